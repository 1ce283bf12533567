// Patches over a triangle and over a square, of degree n in both directions: values, degree elevation by 1
// and subdivision, with one coordinate. Nets are numbers of `bits` bits over one denominator.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/rational/combinatorics.hpp>

#include "cases.hpp"
#include "families.hpp"
#include "flint_patches.hpp"

namespace {

using namespace blossom;

/// The number of points that are evaluated in turn.
constexpr std::size_t most_places = 32;

BezierPatch patch(const NetShape& shape, std::size_t bits) {
    std::mt19937_64 random(shape.size() * 1000 + bits);
    std::vector<Integer> numerators;
    for (std::size_t i = 0; i < shape.size(); ++i) numerators.push_back(number(random, bits).numerator());
    PointArray net(1, RationalVector(std::move(numerators), number(random, bits).denominator()));
    net.make_canonical();
    return {shape, std::move(net)};
}

struct Places {
    std::vector<Rational> u;
    std::vector<Rational> v;
    std::vector<PatchPoint> points;
};

Places places(const NetShape& shape, std::size_t bits) {
    std::mt19937_64 random(shape.size() + bits);
    Places result;
    for (std::size_t i = 0; i < most_places; ++i) {
        const Rational u = number(random, bits);
        const Rational v = number(random, bits);
        result.u.push_back(u);
        result.v.push_back(v);
        if (shape.factors() == 1) {
            result.points.push_back({{1 - u - v, u, v}});
        } else {
            result.points.push_back({{1 - u, u}, {1 - v, v}});
        }
    }
    return result;
}

std::vector<Integer> form_of(const BezierPatch& given) {
    std::vector<Integer> form = multinomials(given.shape());
    for (std::size_t i = 0; i < form.size(); ++i) form[i] *= given.control_net().numbers().numerators()[i];
    return form;
}

std::string text_of(const BezierPatch& given) {
    std::string result;
    const RationalVector& numbers = given.control_net().numbers();
    for (const Integer& numerator : numbers.numerators()) result += to_string(numerator) + " ";
    return result + "/ " + to_string(numbers.denominator());
}

template <class Peer>
void compare_values(const Report& report, const char* work, const NetShape& shape, std::size_t bits) {
    const BezierPatch given = patch(shape, bits);
    const Places at = places(shape, bits);
    const std::size_t degree = shape[0].degree;
    const std::vector<Integer> form = form_of(given);
    Peer flint(static_cast<slong>(degree), form, given.control_net().denominator(), at.u, at.v);
    std::vector<Coordinates> values;
    const auto text = [&] {
        std::string result;
        for (const Coordinates& value : values) result += to_string(value[0]) + " ";
        return result;
    };
    report.compare("patches", work, degree, bits,
                   {{"engine", [&] { values = evaluate(given, at.points); }, text},
                    {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

void compare_values(const Report& report, std::size_t degree, std::size_t bits) {
    if (report.wants("triangle values", degree, bits))
        compare_values<flint_peer::TriangleValues>(report, "triangle values", NetShape::simplex(2, degree),
                                                   bits);
    if (report.wants("tensor values", degree, bits)) {
        compare_values<flint_peer::TensorValues>(report, "tensor values",
                                                 NetShape::tensor(std::vector{degree, degree}), bits);
    }
}

template <class Peer>
void compare_elevation(const Report& report, const char* work, const NetShape& shape, std::size_t bits) {
    const BezierPatch given = patch(shape, bits);
    const std::size_t degree = shape[0].degree;
    Peer flint(static_cast<slong>(degree), given.control_net().numbers());
    std::optional<BezierPatch> raised;
    report.compare("patches", work, degree, bits,
                   {{"engine", [&] { raised = elevate(given, 0, 1); }, [&] { return text_of(*raised); }},
                    {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

template <class Peer, class... Arguments>
void compare_subdivision(const Report& report, const char* work, const NetShape& shape, std::size_t bits,
                         const Coordinates& at, const Arguments&... arguments) {
    const BezierPatch given = patch(shape, bits);
    const std::size_t degree = shape[0].degree;
    Peer flint(static_cast<slong>(degree), given.control_net().numbers(), arguments...);
    std::vector<BezierPatch> pieces;
    const auto text = [&] {
        std::string result;
        for (const BezierPatch& piece : pieces) result += text_of(piece) + " ";
        return result;
    };
    report.compare("patches", work, degree, bits,
                   {{"engine", [&] { pieces = subdivide(given, 0, at); }, text},
                    {"FLINT", [&] { flint.run(); }, [&] { return flint.text(); }}});
}

void compare_operations(const Report& report, std::size_t degree, std::size_t bits) {
    const NetShape triangle = NetShape::simplex(2, degree);
    const NetShape square = NetShape::tensor(std::vector{degree, degree});
    const Places at = places(triangle, bits);
    const Rational& u = at.u[0];
    const Rational& v = at.v[0];
    if (report.wants("triangle elevation", degree, bits))
        compare_elevation<flint_peer::RaisedTriangle>(report, "triangle elevation", triangle, bits);
    if (report.wants("tensor elevation", degree, bits))
        compare_elevation<flint_peer::RaisedTensor>(report, "tensor elevation", square, bits);
    if (report.wants("triangle subdivision", degree, bits)) {
        compare_subdivision<flint_peer::DividedTriangle>(report, "triangle subdivision", triangle, bits,
                                                         {1 - u - v, u, v}, u, v);
    }
    if (report.wants("tensor subdivision", degree, bits)) {
        compare_subdivision<flint_peer::DividedTensor>(report, "tensor subdivision", square, bits, {1 - u, u},
                                                       u);
    }
}

}  // namespace

void measure_patches(const Report& report) {
    for (const std::size_t bits : {4U, 7U, 64U}) {
        for (const std::size_t degree : {3U, 10U, 20U, 50U}) {
            if (report.quick() && degree > 20) continue;
            compare_values(report, degree, bits);
            compare_operations(report, degree, bits);
        }
    }
}
