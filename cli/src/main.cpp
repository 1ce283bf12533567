#include <fcntl.h>
#include <unistd.h>
#include <blossom/rational/resource_budget.hpp>

#include <csignal>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "commands/command_line.hpp"

namespace {

/// Opens /dev/null for each closed standard stream, so that no other file gets its descriptor; reading or
/// writing there still fails.
void reserve_standard_descriptors() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0) continue;
        if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return;
    }
}

/// Writes a message without allocating memory.
int fail(std::string_view message) noexcept {
    for (const std::string_view part : {std::string_view("error: "), message, std::string_view("\n")})
        static_cast<void>(!::write(STDERR_FILENO, part.data(), part.size()));
    return static_cast<int>(blossom::protocol::Outcome::wrong_usage);
}

}  // namespace

int main(int argc, char* argv[]) {
    try {
        reserve_standard_descriptors();
        std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing
        blossom::allocate_numbers_with_new();
        blossom::prepare_thread_for_numbers();
        const std::vector<std::string> arguments(argv + 1, argv + argc);
        return static_cast<int>(blossom::cli::run(arguments, blossom::cli::standard_streams()));
    } catch (const std::bad_alloc&) {
        return fail("the memory of this machine does not suffice");
    } catch (const std::exception& problem) {
        return fail(problem.what());
    } catch (...) {
        return fail("an unknown error of the program");
    }
}
