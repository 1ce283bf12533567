#include "streams.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "printable.hpp"

namespace blossom::cli {

namespace {

std::system_error last_error(const std::string& what) { return {errno, std::generic_category(), what}; }

std::size_t read_some(int descriptor, std::span<char> room, const std::string& name) {
    while (true) {
        const ssize_t count = ::read(descriptor, room.data(), room.size());
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno != EINTR) throw last_error(name);
    }
}

/// Writes all of `text`; false if the other side is closed.
bool write_all(int descriptor, std::string_view text, const std::string& name) {
    while (!text.empty()) {
        const ssize_t count = ::write(descriptor, text.data(), text.size());
        if (count >= 0) {
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno == EPIPE) {
            return false;
        } else if (errno != EINTR) {
            throw last_error(name);
        }
    }
    return true;
}

bool wants_colours(int descriptor) {
    const char* no_color =
        std::getenv("NO_COLOR");                 // NOLINT(concurrency-mt-unsafe): read before threads start
    const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe)
    if ((no_color && *no_color) || !terminal || std::string_view(terminal) == "dumb") return false;
    return ::isatty(descriptor) == 1;
}

}  // namespace

Streams standard_streams() {
    return {
        .input = [](std::span<char> room) { return read_some(STDIN_FILENO, room, "standard input"); },
        .output =
            [terminal = ::isatty(STDOUT_FILENO) == 1](std::string_view text) {
                return terminal ? write_all(STDOUT_FILENO, printable(text), "standard output")
                                : write_all(STDOUT_FILENO, text, "standard output");
            },
        .errors =
            [](std::string_view text) { return write_all(STDERR_FILENO, printable(text), "standard error"); },
        .coloured_output = wants_colours(STDOUT_FILENO),
        .coloured_errors = wants_colours(STDERR_FILENO),
        .shows_progress = wants_colours(STDERR_FILENO),
    };
}

LineReader::Source file_source(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw last_error(path);
    const std::shared_ptr<const int> file(new int(descriptor), [](const int* owned) {
        ::close(*owned);
        delete owned;
    });
    return [file, path](std::span<char> room) { return read_some(*file, room, path); };
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    namespace fs = std::filesystem;
    const auto write = [&](const fs::path& file, int flags) {
        constexpr mode_t readable = 0666;
        const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, readable);
        if (descriptor < 0) throw last_error(path.string());
        const std::unique_ptr<const int, void (*)(const int*)> open(&descriptor,
                                                                    [](const int* own) { ::close(*own); });
        write_all(descriptor, text, path.string());
    };
    const bool exists = fs::exists(path);
    if (exists && ::access(path.c_str(), W_OK) != 0) throw last_error(path.string());
    // A device or a pipe has no contents to protect, so it is written directly.
    if (exists && !fs::is_regular_file(path)) return write(path, 0);
    const fs::path target = exists ? fs::canonical(path) : path;
    if (exists && ::access(target.parent_path().c_str(), W_OK) != 0) return write(target, O_TRUNC);
    const fs::path beside = target.string() + "." + std::to_string(::getpid()) + ".part";
    try {
        write(beside, O_CREAT | O_EXCL);
        if (exists) fs::permissions(beside, fs::status(target).permissions());
        fs::rename(beside, target);
    } catch (...) {
        std::error_code ignored;
        fs::remove(beside, ignored);
        throw;
    }
}

std::string read_all(const LineReader::Source& source, std::size_t longest) {
    std::string text;
    std::string room(1 << 16, '\0');
    while (const std::size_t count = source(room)) {
        require_within(text.size() + count, longest, "line_bytes", "the length of the input, at least");
        text.append(room, 0, count);
    }
    return text;
}

}  // namespace blossom::cli
