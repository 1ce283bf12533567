#pragma once

namespace blossom::worked {

/// One visitor from a function for each alternative.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};

template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace blossom::worked
