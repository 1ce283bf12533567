#include "process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

std::array<int, 2> pipe_ends() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
    return ends;
}

int exit_status(pid_t process) {
    int status = 0;
    if (waitpid(process, &status, 0) != process) fail("waitpid");
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Starts a program with these standard streams.
pid_t start(const std::vector<std::string>& arguments, int input, int output, int errors,
            const char* directory) {
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t process = fork();
    if (process < 0) fail("fork");
    if (process == 0) {
        if (dup2(input, 0) < 0 || dup2(output, 1) < 0 || dup2(errors, 2) < 0 || chdir(directory) != 0)
            _exit(126);
        execv(words[0], words.data());
        _exit(127);
    }
    return process;
}

/// Returns false at the end. A terminal whose program has ended reports EIO.
bool append_some(int descriptor, std::string& text) {
    std::array<char, 4096> room{};
    const ssize_t count = read(descriptor, room.data(), room.size());
    if (count > 0) text.append(room.data(), static_cast<std::size_t>(count));
    return count > 0;
}

Process collect(pid_t process, int output, int errors) {
    Process result{};
    std::array<pollfd, 2> waiting{{{output, POLLIN, 0}, {errors, POLLIN, 0}}};
    while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
        if (poll(waiting.data(), waiting.size(), -1) < 0) fail("poll");
        for (auto& [descriptor, wanted, seen] : waiting) {
            if (descriptor < 0 || seen == 0) continue;
            if (append_some(descriptor, descriptor == output ? result.output : result.errors)) continue;
            close(descriptor);
            descriptor = -1;
        }
    }
    result.status = exit_status(process);
    return result;
}

}  // namespace

Process run_shell(const std::string& command, const std::string& directory) {
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const auto output = pipe_ends();
    const auto errors = pipe_ends();
    const pid_t process = start({"/bin/sh", "-c", command}, nothing, output[1], errors[1], directory.c_str());
    for (const int descriptor : {nothing, output[1], errors[1]}) close(descriptor);
    return collect(process, output[0], errors[0]);
}

Process run_on_terminal(const std::string& command) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) fail("posix_openpt");
    const int other_side = open(ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (other_side < 0) fail("ptsname");
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const auto errors = pipe_ends();
    const pid_t process = start({"/bin/sh", "-c", command}, nothing, other_side, errors[1], ".");
    for (const int descriptor : {nothing, other_side, errors[1]}) close(descriptor);
    return collect(process, terminal, errors[0]);
}

Conversation::Conversation(const std::vector<std::string>& arguments) {
    const auto input = pipe_ends();
    const auto output = pipe_ends();
    process_ = start(arguments, input[0], output[1], 2, ".");
    close(input[0]);
    close(output[1]);
    input_ = input[1];
    output_ = output[0];
}

Conversation::~Conversation() {
    stop_listening();
    if (process_ > 0) finish();
}

void Conversation::send(const std::string& text) const {
    if (write(input_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) fail("write");
}

std::string Conversation::receive() {
    while (received_.find('\n') == std::string::npos) {
        if (!append_some(output_, received_)) fail("the program has ended");
    }
    const std::size_t length = received_.find('\n');
    std::string line = received_.substr(0, length);
    received_.erase(0, length + 1);
    return line;
}

int Conversation::finish() {
    if (input_ >= 0) close(input_);
    input_ = -1;
    const int status = exit_status(process_);
    process_ = -1;
    return status;
}

void Conversation::stop_listening() {
    if (output_ >= 0) close(output_);
    output_ = -1;
}
