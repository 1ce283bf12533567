// Requests of docs/protocol.md, answered without starting a program.

#include <blossom/protocol/answer.hpp>

#include <cstdio>

int main() {
    using namespace blossom;

    for (const char* request : {
             R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2 - t"}, "at": ["1/3"]})",
             R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2 - t"}, "at": ["1/0"]})",
         }) {
        const protocol::Response response = protocol::answer(request);
        std::puts(response.text.c_str());
    }
}
