#include "line_reader.hpp"

#include <algorithm>

namespace blossom::cli {

bool LineReader::refill() {
    rest_ = {buffer_.data(), source_(buffer_)};
    return !rest_.empty();
}

LineReader::Found LineReader::next(std::string& text) {
    if (rest_.empty() && !refill()) return Found::end;
    const std::size_t begin = text.size();
    Found found = Found::line;
    while (true) {
        const std::size_t length = std::min(rest_.find('\n'), rest_.size());
        if (found == Found::too_long || text.size() - begin + length > longest_) {
            found = Found::too_long;
            text.resize(begin);
        } else {
            text.append(rest_, 0, length);
        }
        if (length < rest_.size()) {
            rest_.remove_prefix(length + 1);
            return found;
        }
        if (!refill()) return found;
    }
}

}  // namespace blossom::cli
