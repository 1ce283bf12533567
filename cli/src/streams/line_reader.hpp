#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::cli {

/// Splits the bytes of `source` into lines, and drops the text of a line that is longer than allowed.
class LineReader {
public:
    /// Waits for bytes, writes them to the front of `room` and returns their number; 0 at the end.
    using Source = std::function<std::size_t(std::span<char> room)>;

    enum class Found { line, too_long, end };

    LineReader(Source source, std::size_t longest) : source_(std::move(source)), longest_(longest) {}

    /// Appends the next line to `text`, without its end and as soon as this has arrived; nothing of a line
    /// that is too long. The last line needs no line end.
    Found next(std::string& text);
    /// Whether the next line has already arrived.
    bool has_next() const { return rest_.find('\n') != std::string_view::npos; }

private:
    bool refill();

    Source source_;
    std::size_t longest_;
    std::vector<char> buffer_ = std::vector<char>(1 << 16);
    std::string_view rest_;  ///< bytes of later lines
};

}  // namespace blossom::cli
