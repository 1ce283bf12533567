#pragma once

#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace blossom {

/// The results of function(item) for each item, in order.
template <class Items, class Function>
auto mapped(const Items& items, const Function& function) {
    std::vector<std::decay_t<decltype(std::invoke(function, *std::begin(items)))>> list;
    if constexpr (requires { std::size(items); }) list.reserve(std::size(items));
    for (const auto& item : items) list.push_back(std::invoke(function, item));
    return list;
}

/// The texts text(item) of all items, with `separator` between them.
template <class Items, class Text = std::identity>
std::string joined(const Items& items, const Text& text = {}, std::string_view separator = ", ") {
    std::string all;
    bool first = true;
    for (const auto& item : items) {
        if (!std::exchange(first, false)) all += separator;
        all += std::invoke(text, item);
    }
    return all;
}

}  // namespace blossom
