#include <blossom/core/maps/argument.hpp>

namespace blossom {

std::vector<Argument> with_copies(std::vector<Argument> arguments, std::size_t k, const Argument& repeated) {
    arguments.insert(arguments.end(), k, repeated);
    return arguments;
}

}  // namespace blossom
