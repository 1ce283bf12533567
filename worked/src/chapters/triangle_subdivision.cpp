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

using Vertices = std::vector<std::size_t>;

std::string count_text(const Vertices& replaced) { return replaced.size() == 3 ? "three" : "two"; }

/// One column a part, its control points below each other.
Table parts_table(const TriangleNet& net, const Vertices& replaced) {
    Table table{"The control points of the " + count_text(replaced) + " parts.", {}, {}};
    for (const std::size_t k : replaced) table.header.emplace_back("over " + part_name(k));
    for (const MultiIndex& index : net.indices(0)) {
        std::vector<Cell>& row = table.rows.emplace_back();
        for (const std::size_t k : replaced) row.emplace_back(net.known(without_vertex(index, k)));
    }
    return table;
}

Picture parts_picture(const GivenTriangle& given, const TriangleNet& net, const Vertices& replaced) {
    TrianglePicture picture(given, net, "The control nets of the " + count_text(replaced) + " parts.");
    picture.add_net(0, Role::control);
    for (const std::size_t k : replaced) picture.add_part(k, Role::result);
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
    const Vertices replaced = replaced_vertices(u);
    const bool inside = replaced.size() == 3;
    Document document = begun(given, net, "Subdivision of a triangle", "DeRose, section 5.2");
    document.statement.say("Find the control points over the " + count_text(replaced) +
                           " triangles into which a point" + (inside ? "" : " of an edge") +
                           " divides the given one:");
    document.statement.add(point_display(given, net));

    append_levels(document, given, net);
    document.step(inside ? "Three faces of the pyramid" : "Two faces of the pyramid")
        .say({"The control points over a triangle with the vertex ", symbol("u"),
              " in the place of another are the values without this other one. The pyramid has them on " +
                  std::string(inside ? "its three faces." : "two of its faces.")})
        .add(parts_picture(given, net, replaced));
    document.result.add(parts_table(net, replaced));

    bool holds = true;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const std::size_t k = replaced[part];
        const std::vector<MultiIndex> indices = net.indices(0);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            holds = holds && parts[part].control_net()[i] == net.value(without_vertex(indices[i], k));
        }
        holds = holds && with_frame(parts[part], 0, whole_triangle(u, k, net), limits) == net.patch();
    }
    document.check = {{Paragraph{"Each of the " + count_text(replaced) +
                                 " nets, taken back from its triangle to the whole one, has "
                                 "the given control points again, and so the parts belong to one map."}},
                      holds};
    return document;
}

}  // namespace blossom::worked
