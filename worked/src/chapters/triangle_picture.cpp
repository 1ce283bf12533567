#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "triangle_net.hpp"

namespace blossom::worked {

namespace {

/// The corners of the drawn triangle where its vertices have no coordinates: nearly equilateral.
std::vector<PlanePoint> drawn_corners(const GivenTriangle& given) {
    if (given.frame && given.frame->space_dimension() == 2) {
        return mapped(given.frame->vertices(), place_of);
    }
    return {{0, 0}, {1, 0}, {Rational(1, 2), Rational(7, 8)}};
}

}  // namespace

TrianglePicture::TrianglePicture(const GivenTriangle& given, const TriangleNet& net, std::string caption)
    : net_(net) {
    picture_.caption = std::move(caption);
    const std::size_t dimension = net.patch().dimension();
    if (given.weighted || dimension < 2 || dimension > 3) {
        picture_.corners = drawn_corners(given);
        picture_.caption += " Each name stands over the mean of its arguments in the triangle.";
    } else if (dimension == 3) {
        picture_.projection = {{1, Rational(2, 5), 0}, {0, Rational(3, 10), 1}};
        picture_.caption += " Space is shown in a parallel projection.";
    }
    picture_.description =
        "The control net, the nets of the levels of de Casteljau's algorithm, and their points, named by "
        "their blossom values.";
}

PlanePoint TrianglePicture::shown(const Coordinates& value) const {
    if (picture_.projection.empty()) return place_of(value);
    const auto row = [&](const Coordinates& weights) {
        return std::inner_product(value.begin(), value.end(), weights.begin(), Rational(0));
    };
    return {row(picture_.projection[0]), row(picture_.projection[1])};
}

PlanePoint TrianglePicture::place(const Name& name) const {
    std::vector<Coordinates> arguments;
    for (std::size_t k = 0; k < 4; ++k) {
        arguments.insert(arguments.end(), name[k], k < 3 ? net_.vertices()[k] : net_.u());
    }
    if (picture_.corners.empty()) return shown(blossom_value(net_.patch(), {arguments}, net_.limits()));
    PlanePoint mean{0, 0};
    const Rational share = Rational(1) / Rational(arguments.size());
    for (const Coordinates& argument : arguments) {
        for (std::size_t k = 0; k < 3; ++k) {
            mean.x += share * argument[k] * picture_.corners[k].x;
            mean.y += share * argument[k] * picture_.corners[k].y;
        }
    }
    return mean;
}

void TrianglePicture::add_rows(const std::array<std::size_t, 3>& members, std::size_t level, Role role) {
    const std::size_t m = net_.degree() - level;
    for (std::size_t fixed = 0; fixed < 3; ++fixed) {
        for (std::size_t copies = 0; copies < m; ++copies) {
            PictureLine line{{}, role};
            for (std::size_t i = 0; i + copies <= m; ++i) {
                Name name{0, 0, 0, level};
                name[members[fixed]] = copies;
                name[members[(fixed + 1) % 3]] = i;
                name[members[(fixed + 2) % 3]] = m - copies - i;
                line.places.push_back(place(name));
            }
            picture_.lines.push_back(std::move(line));
        }
    }
}

void TrianglePicture::add_net(std::size_t level, Role role) { add_rows({0, 1, 2}, level, role); }

void TrianglePicture::add_part(std::size_t vertex, Role role) {
    add_rows({3, (vertex + 1) % 3, (vertex + 2) % 3}, 0, role);
}

void TrianglePicture::add_side(std::size_t from, std::size_t to, Role role) {
    if (!picture_.corners.empty() || net_.degree() == 0) return;
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i <= net_.degree(); ++i) {
        Name name{};
        name[from] = net_.degree() - i;
        name[to] += i;
        const PlanePoint at = place(name);
        points.push_back({at.x, at.y});
    }
    std::ranges::move(curves_over(BezierCurve(points), Interval(), role, net_.limits()),
                      std::back_inserter(picture_.curves));
}

void TrianglePicture::add_points(std::size_t level, Role role) {
    for (const MultiIndex& index : net_.indices(level)) {
        picture_.points.push_back({place({index[0], index[1], index[2], level}), net_.name(index), role});
    }
}

}  // namespace blossom::worked
