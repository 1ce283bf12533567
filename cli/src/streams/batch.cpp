#include "batch.hpp"

#include <algorithm>
#include <atomic>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

#include "limit_flags.hpp"
#include "ordered_work.hpp"

namespace blossom::cli {

namespace {

/// Lines that have arrived together: one thread answers them, and their responses are written at once.
struct Part {
    struct Line {
        std::size_t end;  ///< its text begins where that of the line before ends
        bool too_long;
    };

    std::string text;
    std::vector<Line> lines;
    std::vector<Response> responses;

    /// Where the text of the next line begins.
    std::size_t end() const { return lines.empty() ? 0 : lines.back().end; }
};

/// In bytes.
constexpr std::size_t long_response = 4096;

constexpr std::size_t most_bytes_of_part = std::size_t{1} << 16;

/// How many lines make up a part: the more, the shorter their responses are, so that threads and writes wait
/// less for each other, and what is held stays small.
class PartSize {
public:
    std::size_t lines() const { return lines_.load(std::memory_order_relaxed); }
    void adapt(const Part& part) {
        constexpr std::size_t most_lines = 256;
        const bool is_long = std::ranges::any_of(
            part.responses, [](const Response& response) { return response.text.size() > long_response; });
        lines_.store(is_long ? 1 : std::min(2 * part.lines.size(), most_lines), std::memory_order_relaxed);
    }

private:
    std::atomic<std::size_t> lines_{1};
};

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// The response where there was no memory even to say so.
constexpr std::string_view no_memory =
    R"({"ok": false, "error": {"code": "limit_exceeded", "message": "the memory of this machine does not suffice", "at": ""}})"
    "\n";

/// Without a copy of a long text: it may have taken the last memory.
bool write_line(const Sink& sink, std::string& text) {
    if (text.empty()) return sink(no_memory);
    if (text.size() == text.capacity() && text.size() > long_response) return sink(text) && sink("\n");
    try {
        text += '\n';
    } catch (const std::bad_alloc&) {
        return sink(text) && sink("\n");
    }
    return sink(text);
}

/// At once where there is memory for it.
bool write_lines(const Sink& sink, std::vector<Response>& responses) {
    std::string text;
    try {
        text.reserve(std::accumulate(
            responses.begin(), responses.end(), responses.size(),
            [](std::size_t sum, const Response& response) { return sum + response.text.size(); }));
    } catch (const std::bad_alloc&) {
        return std::ranges::all_of(responses,
                                   [&](Response& response) { return write_line(sink, response.text); });
    }
    for (const Response& response : responses) {
        if (response.text.empty()) {
            text += no_memory;
        } else {
            (text += response.text) += '\n';
        }
    }
    return sink(text);
}

}  // namespace

Outcome serve_batch(const LineReader::Source& source, const Sink& sink, const Limits& limits,
                    std::size_t jobs) {
    LineReader reader(source, limits.line_bytes);
    Outcome outcome = Outcome::success;
    PartSize size;
    const auto answer = [&](Part& part) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < part.lines.size(); ++i) {
            const auto [end, too_long] = part.lines[i];
            const std::string_view line = std::string_view(part.text).substr(begin, end - begin);
            begin = end;
            try {
                part.responses[i] = too_long ? protocol::refuse_long_line(limits, add_flag)
                                             : protocol::answer(line, limits, add_flag);
            } catch (const std::bad_alloc&) {
                part.responses[i] = {"", Outcome::refused};
            }
        }
        std::string().swap(part.text);
        size.adapt(part);
    };
    const auto write = [&](Part& part) {
        for (const Response& response : part.responses) outcome = std::max(outcome, response.outcome);
        const bool taken = part.responses.size() == 1 ? write_line(sink, part.responses.front().text)
                                                      : write_lines(sink, part.responses);
        if (!taken) outcome = std::max(outcome, Outcome::refused);
        return taken;
    };
    OrderedWork<Part> work(jobs, answer, write);
    Part part;
    while (true) {
        const LineReader::Found found = reader.next(part.text);
        if (found == LineReader::Found::end) break;
        const bool too_long = found == LineReader::Found::too_long;
        if (!too_long && is_blank(std::string_view(part.text).substr(part.end()))) {
            part.text.resize(part.end());
        } else {
            part.lines.push_back({part.text.size(), too_long});
        }
        const bool has_room = part.lines.size() < size.lines() && part.text.size() < most_bytes_of_part;
        if (part.lines.empty() || (reader.has_next() && has_room)) continue;
        part.responses.resize(part.lines.size());
        if (!work.add(std::exchange(part, Part()))) break;
    }
    work.finish();
    return outcome;
}

}  // namespace blossom::cli
