#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace blossom::cli {

/// The shells that completion scripts are written for, as "bash|zsh|fish".
inline constexpr std::string_view completion_shells = "bash|zsh|fish";

/// A script that makes the shell complete the commands, options and fixed values of `app`.
std::string completion_script(const CLI::App& app, std::string_view shell);

}  // namespace blossom::cli
