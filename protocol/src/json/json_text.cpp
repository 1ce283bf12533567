#include "json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <type_traits>

namespace blossom::protocol {

namespace {

/// The reader's type for numbers that fit no 64-bit integer. Their text is all that counts here: it accepts
/// what would overflow a double and holds nothing of it.
class UnreadNumber {
public:
    UnreadNumber() = default;
    UnreadNumber(int) : scratch_(0) {}       // NOLINT(google-explicit-constructor): the reader assigns 0
    operator double&() { return scratch_; }  // NOLINT(google-explicit-constructor): what strtod writes to
    operator double() const { return 0; }    // NOLINT(google-explicit-constructor): always finite

private:
    double scratch_;  // NOLINT(modernize-use-default-member-init): the reader holds it in a union
};

using Reader =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, UnreadNumber>;

/// Builds a `Json` from the reader's events.
class Builder : public nlohmann::json_sax<Reader> {
public:
    explicit Builder(const Limits& limits) : limits_(limits) {}

    bool null() override { return add(Json()); }
    bool boolean(bool value) override { return add(value); }
    // Zero comes as a signed integer only when it was written "-0".
    bool number_integer(std::int64_t value) override {
        return add(Json::Number{value == 0 ? "-0" : std::to_string(value)});
    }
    bool number_unsigned(std::uint64_t value) override { return add(Json::Number{std::to_string(value)}); }
    bool number_float(UnreadNumber, const std::string& text) override { return add(Json::Number{text}); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(Reader::binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(Json::Object{}); }
    bool key(std::string& name) override {
        keys_.back() = std::move(name);
        return true;
    }
    bool end_object() override { return has_distinct_names(open_.back()) && close(); }
    bool start_array(std::size_t) override { return open(Json::Array{}); }
    bool end_array() override { return close(); }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& problem) override {
        std::string_view message = problem.what();
        // "[...] parse error at line 1, column 9: syntax error ...; last read: '...'": the place is told
        // once, in bytes, and what was read last may be as long as the line.
        const std::size_t start = message.find(": ");
        message.remove_prefix(start == std::string_view::npos ? 0 : start + 2);
        message = message.substr(0, message.find("; last read"));
        const std::size_t offset = position == 0 ? 0 : position - 1;
        fail({ErrorCode::syntax,
              "byte " + std::to_string(position) + ": " + std::string(message),
              {},
              offset});
        return false;
    }

    JsonReading take() {
        // Of what is open only the outermost is handed out, with the members that were read whole.
        if (error_ && !open_.empty()) root_ = std::move(open_.front());
        return {std::move(root_), std::move(error_)};
    }
    void fail(Error error) {
        if (!error_) error_ = std::move(error);
    }

private:
    bool add(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (Json::Array* elements = open_.back().array()) {
            elements->push_back(std::move(value));
        } else {
            open_.back().object()->emplace_back(std::move(keys_.back()), std::move(value));
        }
        return true;
    }
    bool open(Json container) {
        if (open_.size() >= limits_.nesting) {
            fail({ErrorCode::limit_exceeded,
                  "brackets nested deeper than the limit nesting = " + std::to_string(limits_.nesting)});
            return false;
        }
        open_.push_back(std::move(container));
        keys_.emplace_back();
        return true;
    }
    bool close() {
        Json container = std::move(open_.back());
        open_.pop_back();
        keys_.pop_back();
        return add(std::move(container));
    }
    bool has_distinct_names(const Json& object) {
        std::vector<std::string_view> names;
        for (const auto& [name, value] : *object.object()) names.push_back(name);
        std::ranges::sort(names);
        const auto repeated = std::ranges::adjacent_find(names);
        if (repeated == names.end()) return true;
        fail({ErrorCode::syntax, "the name " + to_text(Json(*repeated)) + " occurs twice in one object",
              place()});
        return false;
    }
    /// Of the innermost open container.
    Place place() const {
        Place place;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
            const Json::Array* elements = open_[i].array();
            place = elements ? place / elements->size() : place / keys_[i];
        }
        return place;
    }

    const Limits& limits_;
    Json root_;
    std::vector<Json> open_;         ///< the containers around the place that is being read
    std::vector<std::string> keys_;  ///< for each, the name of the member that is being read
    std::optional<Error> error_;
};

}  // namespace

JsonReading read_json(std::string_view text, const Limits& limits) {
    Builder builder(limits);
    // The reader takes a zero byte for the end of the text.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        builder.fail({ErrorCode::syntax, "byte " + std::to_string(zero + 1) + ": a zero byte", {}, zero});
    } else {
        Reader::sax_parse(text.begin(), text.end(), &builder);
    }
    return builder.take();
}

Json parse_json(std::string_view text, const Limits& limits) {
    JsonReading reading = read_json(text, limits);
    if (reading.error) throw Error(*reading.error);
    return std::move(reading.value);
}

}  // namespace blossom::protocol
