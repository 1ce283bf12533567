#include <blossom/worked/picture.hpp>

namespace blossom::worked {

std::string role_name(Role role) {
    switch (role) {
        case Role::control:
            return "control";
        case Role::construction:
            return "construction";
        case Role::result:
            return "result";
        case Role::second:
            return "second";
    }
    return "";
}

}  // namespace blossom::worked
