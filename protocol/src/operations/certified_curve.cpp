#include "certified_curve.hpp"

#include <fmt/format.h>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "along_direction.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "segment.hpp"

namespace blossom::protocol {

namespace {

struct GivenCurve {
    std::optional<std::size_t> span;
    const Limits& limits;

    CertifiedMap operator()(const PolynomialCurve& curve) const { return {curve, {}}; }
    CertifiedMap operator()(const OnePolynomial auto& curve) const {
        CertifiedMap given{monomial_form(polynomial_map(curve, limits), limits), {}};
        given.values = claims(stated_values(curve), given.curve.degree(), 0);
        for (CertifiedValue& value : given.values) value.name.insert(0, "given ");
        return given;
    }
    CertifiedMap operator()(const BSplineCurve& curve) const {
        return (*this)(segment(curve, chosen_span(curve, span)));
    }
};

}  // namespace

std::vector<CertifiedValue> claims(std::vector<StatedValue> stated, std::size_t degree, std::size_t order) {
    const std::size_t vectors = std::min(order, degree);
    std::vector<CertifiedValue> list;
    for (auto& [name, index, arguments, multiple, point] : stated) {
        // Derivatives of an order above the degree are zero: 0 times any value.
        arguments.resize(std::min(arguments.size(), degree - vectors), delta);
        list.push_back({fmt::format("{} {}", name, index), with_copies(std::move(arguments), vectors, delta),
                        falling_factorial(degree, order) * multiple, std::move(point)});
    }
    return list;
}

CertifiedMap certified_direction(const Patch& patch, std::size_t direction, const Limits& limits) {
    const GivenCurve given{{}, limits};
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map))
        return given(curve_along(*polynomial, direction));
    return given(curve_along(placed_tensor(patch, limits), direction));
}

CertifiedMap certified_map(const Map& map, std::optional<std::size_t> span, const Limits& limits) {
    return dispatch_on_kind<CertifiedMap>(map, GivenCurve{span, limits});
}

}  // namespace blossom::protocol
