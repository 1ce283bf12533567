#include <blossom/rational/resource_budget.hpp>

#include <string>
#include <vector>

#include "commands/command_line.hpp"

int main(int argc, char* argv[]) {
    blossom::allocate_numbers_with_new();
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return static_cast<int>(blossom::cli::run(arguments, blossom::cli::standard_streams()));
}
