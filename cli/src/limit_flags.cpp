#include "limit_flags.hpp"

#include <algorithm>

namespace blossom::cli {

std::string flag_of(const LimitEntry& limit) {
    if (limit.member == &Limits::timeout) return "--timeout";
    std::string text = "--max-" + std::string(limit.name);
    std::ranges::replace(text, '_', '-');
    return text;
}

std::string flag_of(const Error& error) {
    const auto named = std::ranges::find(limit_table(), error.limit(), &LimitEntry::name);
    return named == limit_table().end() ? "" : flag_of(*named);
}

Error with_flag(const Error& error) {
    const std::string flag = flag_of(error);
    return flag.empty() ? error : error.saying(error.message() + " (" + flag + ")");
}

void add_flag(const Error& error, Json::Object& members) {
    if (std::string flag = flag_of(error); !flag.empty()) members.emplace_back("flag", std::move(flag));
}

}  // namespace blossom::cli
