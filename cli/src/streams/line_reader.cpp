#include "line_reader.hpp"

#include <algorithm>

namespace blossom::cli {

bool LineReader::refill() {
    rest_ = {buffer_.data(), source_(buffer_)};
    return !rest_.empty();
}

std::optional<LineReader::Line> LineReader::next() {
    if (rest_.empty() && !refill()) return std::nullopt;
    Line line;
    while (true) {
        const std::size_t length = std::min(rest_.find('\n'), rest_.size());
        if (line.too_long || line.text.size() + length > longest_) {
            line.too_long = true;
            std::string().swap(line.text);
        } else {
            line.text.append(rest_, 0, length);
        }
        if (length < rest_.size()) {
            rest_.remove_prefix(length + 1);
            return line;
        }
        if (!refill()) return line;
    }
}

}  // namespace blossom::cli
