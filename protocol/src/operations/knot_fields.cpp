#include "knot_fields.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace blossom::protocol {

namespace {

constexpr std::string_view convention_names[] = {"textbook", "polar"};

}  // namespace

KnotFields read_knot_fields(Fields& fields, const Limits& limits) {
    KnotFields read;
    read.degree = fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    read.knots = fields.required("knots", [&](const Json& value) { return read_numbers(value, limits); });
    const auto convention = fields.optional("convention", [](const Json& value) {
        return read_alternative(value, convention_names, "a convention of knots");
    });
    read.polar = convention == 1;
    return read;
}

KnotVector knot_vector(KnotFields fields) {
    const auto& [degree, knots, polar] = fields;
    const std::size_t more = polar ? knots.size() + 1 : knots.size();
    const std::size_t fewer = polar ? degree : degree + 1;
    if (more <= fewer + degree || (polar && degree == 0)) {
        throw Error(ErrorCode::bad_knots,
                    std::to_string(knots.size()) + " knots of degree " + std::to_string(degree) +
                        " are too few for a domain in this convention",
                    Place{"knots"});
    }
    const std::size_t points = more - fewer;
    return {degree, std::move(fields.knots), points};
}

FieldList knot_members() {
    return {
        required("degree", ValueKind::count, "the degree"),
        required("knots", Shape::list(ValueKind::number), "the knots"),
        optional("convention", Shape::words(convention_names),
                 "textbook (the default): with the first and last knot, on which no point depends; polar: "
                 "without them")};
}

}  // namespace blossom::protocol
