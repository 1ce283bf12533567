#include "streams/batch.hpp"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "protocol/answered.hpp"
#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::cli;

namespace {

/// Delivers `text` in pieces of at most `piece` bytes.
LineReader::Source source_of(std::string text, std::size_t piece = 1 << 16) {
    return [text = std::move(text), piece, start = std::size_t{0}](std::span<char> room) mutable {
        const std::size_t count = std::min({piece, room.size(), text.size() - start});
        std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(start), count, room.begin());
        start += count;
        return count;
    };
}

struct Batch {
    std::vector<std::string> responses;
    Outcome outcome;
};

Batch serve(const LineReader::Source& source, std::size_t jobs = 1, const Limits& limits = {}) {
    Batch batch;
    const auto sink = [&](std::string_view lines) {
        REQUIRE(lines.ends_with('\n'));
        while (!lines.empty()) {
            const std::size_t length = lines.find('\n');
            batch.responses.emplace_back(lines.substr(0, length));
            lines.remove_prefix(length + 1);
        }
        return true;
    };
    batch.outcome = serve_batch(source, sink, limits, jobs);
    return batch;
}

std::string request(std::size_t id, const std::string& more = "") {
    return R"({"id": )" + std::to_string(id) +
           R"(, "op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": [)" +
           std::to_string(id) + "]" + more + "}\n";
}
std::string response(std::size_t id) {
    return R"({"id": )" + std::to_string(id) + R"(, "ok": true, "result": {"values": [")" +
           std::to_string(id * id) + "\"]}}";
}
bool is_error(const std::string& line, const std::string& code) {
    CAPTURE(line);
    return line.find(R"("ok": false, "error": {"code": ")" + code + "\"") != std::string::npos;
}

}  // namespace

TEST_CASE("lines are split wherever they arrive in pieces") {
    for (const std::size_t piece : std::vector<std::size_t>{1, 2, 3, 7, 100}) {
        LineReader reader(source_of("a\n\nbcd\r\nlast", piece), 4);
        std::vector<std::string> lines;
        for (std::string line; reader.next(line) != LineReader::Found::end; line.clear())
            lines.push_back(line);
        CHECK(lines == std::vector<std::string>{"a", "", "bcd\r", "last"});
    }
}

TEST_CASE("a line is too long from one byte beyond the limit") {
    for (const std::size_t piece : std::vector<std::size_t>{1, 3, 100}) {
        LineReader reader(source_of("1234\n12345\n123456789\n1\n12345", piece), 4);
        using enum LineReader::Found;
        std::vector<LineReader::Found> found;
        std::string text;
        do found.push_back(reader.next(text));
        while (found.back() != end);
        CHECK(found == std::vector{line, too_long, too_long, line, too_long, end});
        CHECK(text == "12341");
        CHECK(text.capacity() <= 64);
    }
}

TEST_CASE("responses come in the order of the requests, whatever the jobs") {
    std::string text;
    for (std::size_t id = 0; id < 2000; ++id) text += request(id);
    for (const std::size_t jobs : std::vector<std::size_t>{1, 2, 3, 16}) {
        const Batch batch = serve(source_of(text), jobs);
        CHECK(batch.outcome == Outcome::success);
        REQUIRE(batch.responses.size() == 2000);
        for (std::size_t id = 0; id < 2000; ++id) REQUIRE(batch.responses[id] == response(id));
    }
}

TEST_CASE("a slow request does not let a quick one pass") {
    const std::string slow =
        R"({"op": "blossom", "construction": "polarization", "map": {"kind": "polynomial", "text": "t^14"},
 "arguments": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14]})";
    std::string line = slow;
    std::ranges::replace(line, '\n', ' ');
    const Batch batch = serve(source_of(line + "\n" + request(5) + line + "\n" + request(6)), 4);
    REQUIRE(batch.responses.size() == 4);
    CHECK(batch.responses[0] == batch.responses[2]);
    CHECK(batch.responses[1] == response(5));
    CHECK(batch.responses[3] == response(6));
}

TEST_CASE("a bad line is answered and the next is served") {
    for (const std::size_t jobs : std::vector<std::size_t>{1, 4}) {
        const Batch batch = serve(
            source_of("nonsense\n" + request(3) + "{\"op\": \"none\"}\n" + request(4, ", \"x\": 1")), jobs);
        REQUIRE(batch.responses.size() == 4);
        CHECK(batch.outcome == Outcome::refused);
        CHECK(is_error(batch.responses[0], "syntax"));
        CHECK(batch.responses[1] == response(3));
        CHECK(is_error(batch.responses[2], "unknown_op"));
        CHECK(is_error(batch.responses[3], "unknown_field"));
    }
}

TEST_CASE("blank lines are skipped, line ends may be CRLF, and the last may be missing") {
    std::string text = request(1);
    text.insert(text.size() - 1, "\r");
    const Batch batch =
        serve(source_of("\n  \t\r\n" + text + "\n\r\n" + request(2).substr(0, request(2).size() - 1)));
    CHECK(batch.outcome == Outcome::success);
    CHECK(batch.responses == std::vector<std::string>{response(1), response(2)});
    CHECK(serve(source_of("")).responses.empty());
    CHECK(serve(source_of("\n\n")).outcome == Outcome::success);
}

TEST_CASE("a line over the limit is refused without being stored and the next is served") {
    Limits limits;
    limits.line_bytes = 1000;
    // 200 MB, more than any buffer of the program may hold.
    const auto endless = [sent = std::size_t{0}, tail = "\n" + request(9)](std::span<char> room) mutable {
        constexpr std::size_t length = 200'000'000;
        if (sent < length) {
            std::ranges::fill(room, '[');
            sent += room.size();
            return room.size();
        }
        const std::size_t count = std::min(tail.size(), room.size());
        std::copy_n(tail.begin(), count, room.begin());
        tail.erase(0, count);
        return count;
    };
    for (const std::size_t jobs : std::vector<std::size_t>{1, 2}) {
        const Batch batch = serve(endless, jobs, limits);
        REQUIRE(batch.responses.size() == 2);
        CHECK(is_error(batch.responses[0], "limit_exceeded"));
        CHECK(batch.responses[0].find("line_bytes = 1000") != std::string::npos);
        CHECK(batch.responses[1] == response(9));
    }
}

TEST_CASE("what exceeds a limit is refused with its name, the amount and the flag that raises it") {
    const std::string line =
        R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^21"}, "at": ["1e30"]})";
    const auto refusal = [&](const Limits& limits) {
        return serve(source_of(line + "\n"), 1, limits).responses.at(0);
    };
    Limits limits;
    limits.degree = 20;
    CHECK(refusal(limits) == R"({"ok": false, "error": {"code": "limit_exceeded", "message": )"
                             R"("column 3: the exponent 21 exceeds the limit degree = 20", )"
                             R"("at": "/map/text", "limit": "degree", "flag": "--max-degree"}})");
    limits = {};
    limits.work = 10;
    CHECK(refusal(limits).ends_with(R"( the limit work = 10 word operations", "at": "/at/0", )"
                                    R"("limit": "work", "flag": "--max-work"}})"));
    limits = {};
    limits.line_bytes = 10;
    CHECK(refusal(limits).ends_with(R"(the limit line_bytes = 10", "at": "", )"
                                    R"("limit": "line_bytes", "flag": "--max-line-bytes"}})"));
}

TEST_CASE("a peer that waits for each response gets it, with any number of jobs") {
    for (const std::size_t jobs : std::vector<std::size_t>{1, 2, 8}) {
        std::mutex mutex;
        std::condition_variable answered;
        std::size_t responses = 0;
        // The next line is sent only after the response to the previous one has arrived; otherwise the test
        // would never end.
        const auto source = [&, sent = std::size_t{0}](std::span<char> room) mutable {
            std::unique_lock lock(mutex);
            answered.wait(lock, [&] { return responses == sent; });
            if (sent == 50) return std::size_t{0};
            const std::string line = request(sent++);
            std::ranges::copy(line, room.begin());
            return line.size();
        };
        const auto sink = [&](std::string_view line) {
            const std::scoped_lock lock(mutex);
            CHECK(line == response(responses) + "\n");
            ++responses;
            answered.notify_one();
            return true;
        };
        CHECK(serve_batch(source, sink, Limits{}, jobs) == Outcome::success);
        CHECK(responses == 50);
    }
}

TEST_CASE("a batch ends when nobody takes the responses") {
    for (const std::size_t jobs : std::vector<std::size_t>{1, 4}) {
        std::size_t requests = 0;
        const auto endless = [&](std::span<char> room) {
            const std::string line = request(requests++);
            std::ranges::copy(line, room.begin());
            return line.size();
        };
        std::size_t responses = 0;
        const auto sink = [&](std::string_view) { return ++responses < 10; };
        CHECK(serve_batch(endless, sink, Limits{}, jobs) == Outcome::refused);
        CHECK(responses == 10);
        CHECK(requests <= 10 + 4 * jobs + 1);
    }
}

TEST_CASE("what writing throws comes out of the batch") {
    for (const std::size_t jobs : std::vector<std::size_t>{1, 4}) {
        const auto sink = [](std::string_view) -> bool { throw std::runtime_error("full"); };
        CHECK_THROWS_WITH(serve_batch(source_of(request(1) + request(2)), sink, Limits{}, jobs), "full");
    }
}

TEST_CASE("only so many lines are held ahead of the first that is not answered") {
    constexpr std::size_t jobs = 2;
    std::mutex mutex;
    std::size_t sent = 0;
    std::size_t answered = 0;
    std::size_t most_ahead = 0;
    const auto source = [&](std::span<char> room) {
        const std::scoped_lock lock(mutex);
        if (sent == 3000) return std::size_t{0};
        const std::string line = request(sent++);
        most_ahead = std::max(most_ahead, sent - answered);
        std::ranges::copy(line, room.begin());
        return line.size();
    };
    const auto sink = [&](std::string_view) {
        const std::scoped_lock lock(mutex);
        ++answered;
        return true;
    };
    serve_batch(source, sink, Limits{}, jobs);
    CHECK(answered == 3000);
    CHECK(most_ahead <= 4 * jobs + 2);
}
