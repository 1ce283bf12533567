#include "batch.hpp"

#include <algorithm>

#include "ordered_work.hpp"

namespace blossom::cli {

namespace {

struct Request {
    LineReader::Line line;
    Response response = {};
};

/// Without more memory than the text has: a long response may have taken the last.
bool write_line(const Sink& sink, std::string& text) {
    if (text.size() == text.capacity()) return sink(text) && sink("\n");
    text += '\n';
    return sink(text);
}

bool is_blank(const LineReader::Line& line) {
    return !line.too_long && line.text.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

Outcome serve_batch(const LineReader::Source& source, const Sink& sink, const Limits& limits,
                    std::size_t jobs) {
    LineReader reader(source, limits.line_bytes);
    Outcome outcome = Outcome::success;
    const auto answer = [&](Request& request) {
        const LineReader::Line line = std::move(request.line);
        request.response =
            line.too_long ? protocol::refuse_long_line(limits) : protocol::answer(line.text, limits);
    };
    const auto write = [&](Request& request) {
        const bool taken = write_line(sink, request.response.text);
        outcome = std::max({outcome, request.response.outcome, taken ? Outcome::success : Outcome::refused});
        return taken;
    };
    OrderedWork<Request> work(jobs, answer, write);
    while (auto line = reader.next()) {
        if (!is_blank(*line) && !work.add({std::move(*line)})) break;
    }
    work.finish();
    return outcome;
}

}  // namespace blossom::cli
