#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/worked/chapters.hpp>

#include <algorithm>

#include "splines.hpp"

namespace blossom::worked {

namespace {

/// The values of both segments with k arguments beside the knot.
std::vector<Cell> row(const BSplineCurve& curve, std::size_t left, std::size_t right, const Rational& knot,
                      std::size_t k, const Limits& limits) {
    const auto arguments =
        with_copies(with_copies({}, curve.degree() - k, Parameter(knot)), k, Parameter(knot + Rational(1)));
    const Coordinates before = segment_blossom(curve, left, arguments, limits);
    const Coordinates after = segment_blossom(curve, right, arguments, limits);
    return {
        number(k), tuple(argument_formulas(arguments)),
        Cell(point_formula(before), spline_value(arguments, left)),
        Cell(point_formula(after), spline_value(arguments, right)),
        before == after
            ? Cell("equal", relation("=", {spline_value(arguments, left), spline_value(arguments, right)}))
            : Cell("different",
                   relation("≠", {spline_value(arguments, left), spline_value(arguments, right)}))};
}

}  // namespace

Document continuity_at(const BSplineCurve& curve, const Rational& knot, const Limits& limits) {
    Document document = begun(curve, "Continuity at a knot", "DeRose, theorem 2 and section 4.6");
    const Contact joint = contact(curve, knot, limits);
    const std::size_t left = curve.knots().span_before(knot);
    const std::size_t right = curve.knots().span_at(knot);
    document.statement.say({"Find how smoothly the segments on both sides of ", number(knot), " meet."});
    Table table{"Both blossoms at the knot and beside it.",
                {symbol("k"), "arguments", "segment before", "segment after", "values"},
                {}};
    const std::size_t last = joint.order ? static_cast<std::size_t>(*joint.order + 1) : curve.degree();
    for (std::size_t k = 0; k <= std::min(last, curve.degree()); ++k) {
        table.rows.push_back(row(curve, left, right, knot, k, limits));
    }
    document.step("Compare the blossoms")
        .say({"Two maps meet with order ", symbol("k"),
              " exactly when their blossoms agree wherever all but ", symbol("k"),
              std::string(" arguments are the knot. As they are affine in each "
                          "argument, it is enough to put "),
              number(knot + Rational(1)), " for these ", symbol("k"), "."})
        .add(std::move(table));
    const std::size_t multiplicity = curve.knots().multiplicity(knot);
    document.result.add(joint.is_infinite()
                            ? Paragraph{"All values agree: both segments are one polynomial, and the curve "
                                        "has all derivatives here."}
                            : Paragraph{{"The values agree up to ", symbol("k"), " = ",
                                         number(Rational(Integer(static_cast<std::int64_t>(*joint.order)))),
                                         " and not beyond: the curve meets with this order."}});
    if (const auto plane = plane_spline(curve)) {
        document.result.add(spline_picture(*plane, "The curve with its control polygon.", limits));
    }
    const auto promised =
        static_cast<std::ptrdiff_t>(curve.degree()) - static_cast<std::ptrdiff_t>(multiplicity);
    document.check = {
        {Paragraph{{"A knot of multiplicity ", symbol("m"), " in a spline of degree ", symbol("n"),
                    " promises order ", sum({symbol("n"), product({number(-1), symbol("m")})}), "; here ",
                    symbol("m"), " is ", number(multiplicity), " and ", symbol("n"), " is ",
                    number(curve.degree()), ", and the order found is at least that."}}},
        joint.is_infinite() || *joint.order >= promised};
    return document;
}

}  // namespace blossom::worked
