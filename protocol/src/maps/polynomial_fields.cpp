#include "polynomial_fields.hpp"

#include <fmt/format.h>

namespace blossom::protocol {

PointForm read_polynomial_form(Fields& fields, std::size_t coordinates, bool scalar, bool has_denominator) {
    if (!read_homogeneous(fields)) return {.scalar = scalar, .rational = has_denominator};
    if (!has_denominator && (scalar || coordinates < 2)) {
        throw Error(
            ErrorCode::mismatched_dimensions,
            R"(with "homogeneous": true and no "denominator", a map has at least 1 coordinate and a weight)",
            Place{"homogeneous"});
    }
    return {.scalar = false, .rational = true, .homogeneous = true};
}

std::string coordinates_text(std::vector<std::string> texts, const PointForm& form) {
    std::string denominator;
    if (form.separate_weights()) {
        denominator = fmt::format(" / ({})", texts.back());
        texts.pop_back();
    }
    const std::string text = fmt::format("{}", fmt::join(texts, ", "));
    return form.scalar && denominator.empty() ? text : "(" + text + ")" + denominator;
}

}  // namespace blossom::protocol
