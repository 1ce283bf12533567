#include <blossom/core/blossom/patch_subdivision.hpp>

#include "triangle_net.hpp"

namespace blossom::worked {

namespace {

/// Index `index` of the part in which u replaces vertex k, as copies of r, s and t.
MultiIndex without_vertex(MultiIndex index, std::size_t k) {
    index[k] = 0;
    return index;
}

std::string part_name(std::size_t vertex) {
    std::string name = "r, s, t";
    name[3 * vertex] = 'u';
    return name;
}

/// One column a part, its control points below each other.
Table parts_table(const TriangleNet& net) {
    Table table{"The control points of the three parts.", {}, {}};
    for (std::size_t k = 0; k < 3; ++k) table.header.emplace_back("over " + part_name(k));
    for (const MultiIndex& index : net.indices(0)) {
        std::vector<Cell>& row = table.rows.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) row.emplace_back(net.known(without_vertex(index, k)));
    }
    return table;
}

Picture parts_picture(const GivenTriangle& given, const TriangleNet& net) {
    TrianglePicture picture(given, net, "The control nets of the three parts.");
    picture.add_net(0, Role::control);
    for (std::size_t k = 0; k < 3; ++k) picture.add_part(k, Role::result);
    for (std::size_t k = 0; k < 3; ++k) picture.add_side(k, (k + 1) % 3, Role::control);
    for (std::size_t k = 0; k < 3; ++k) picture.add_side(k, 3, Role::second);
    for (std::size_t level = 0; level <= net.degree(); ++level) {
        if (level > 0 && level < net.degree() && net.degree() > TrianglePicture::named_degree) continue;
        picture.add_points(level, level == 0 ? Role::control : Role::result);
    }
    return picture.done();
}

/// u as an argument of part k in the coordinates of this part, so that vertex k of the whole is regained.
std::vector<Coordinates> whole_triangle(const Coordinates& u, std::size_t k, const TriangleNet& net) {
    std::vector<Coordinates> elements(net.vertices().begin(), net.vertices().end());
    // v_k = (u - sum of the others with their weights) / u_k.
    for (std::size_t j = 0; j < 3; ++j) {
        elements[k][j] = j == k ? Rational(1) / u[k] : -u[j] / u[k];
    }
    return elements;
}

}  // namespace

Document triangle_subdivision(const GivenTriangle& given, const Coordinates& u, const Limits& limits) {
    const TriangleNet net(given, u, limits);
    const std::vector<BezierPatch> parts = subdivide(net.patch(), 0, u, limits);
    Document document = begun(given, net, "Subdivision of a triangle", "DeRose, section 5.2");
    document.statement.say(
        "Find the control points over the three triangles into "
        "which a point divides the given one:");
    document.statement.add(point_display(given, net));

    append_levels(document, given, net);
    document.step("Three faces of the pyramid")
        .say({"The control points over a triangle with the vertex ", symbol("u"),
              " in the place of another are the values without this other one. The pyramid has them on "
              "its three faces."})
        .add(parts_picture(given, net));
    document.result.add(parts_table(net));

    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<MultiIndex> indices = net.indices(0);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            holds = holds && parts[k].control_net()[i] == net.value(without_vertex(indices[i], k));
        }
        holds = holds && with_frame(parts[k], 0, whole_triangle(u, k, net), limits) == net.patch();
    }
    document.check = {{Paragraph{"Each of the three nets, taken back from its triangle to the whole one, has "
                                 "the given control points again, and so the parts belong to one map."}},
                      holds};
    return document;
}

}  // namespace blossom::worked
