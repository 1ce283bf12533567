#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/net_steps.hpp>

#include <algorithm>
#include <bit>
#include <optional>
#include <string>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

/// For each vertex, the net in which the argument, or a multiple of it, replaces this vertex.
std::vector<BezierPatch> with_vertices_replaced(const BezierPatch& patch, std::size_t factor,
                                                const Coordinates& argument,
                                                std::span<const std::size_t> vertices, const Limits& limits) {
    const NetShape& shape = patch.shape();
    const std::size_t degree = shape[factor].degree;
    const PointArray& net = patch.control_net();
    const IntegerTuple tuple = cleared(argument);
    require_result_bits(bits_of(net) + degree * tuple.bits(), limits);
    require_within(vertices.size() * net.numbers().size(), limits.numbers, "numbers",
                   "the number of coordinates of the pieces");
    auto pieces =
        blossom::with_vertices_replaced({net.numbers().numerators(), shape[factor], shape.behind(factor)},
                                        tuple.entries, tuple.scale, vertices);
    const Integer denominator = net.denominator() * pow(tuple.scale, degree);
    std::vector<BezierPatch> patches;
    patches.reserve(pieces.size());
    for (auto& numerators : pieces)
        patches.emplace_back(shape, canonical_points(net.dimension(), std::move(numerators), denominator));
    return patches;
}

/// The net with element order[k] of the frame in position k.
BezierPatch permuted(const BezierPatch& patch, std::size_t factor, std::span<const std::size_t> order) {
    const NetShape& shape = patch.shape();
    const std::vector<MultiIndex> indices = multi_indices(shape[factor].dimension, shape[factor].degree);
    const std::size_t behind = shape.behind(factor);
    std::vector<std::size_t> source;
    for (const MultiIndex& index : indices) {
        MultiIndex old(index.size());
        for (std::size_t k = 0; k < order.size(); ++k) old[order[k]] = index[k];
        source.push_back(position(old));
    }
    const auto rows = each_row(patch.control_net(), [&](std::span<const Integer> row) {
        std::vector<Integer> net;
        net.reserve(row.size());
        for (std::size_t block = 0; block < row.size(); block += source.size() * behind) {
            for (const std::size_t place : source) {
                for (std::size_t k = 0; k < behind; ++k) net.push_back(row[block + place * behind + k]);
            }
        }
        return net;
    });
    return {shape, canonical_points(rows, patch.control_net().denominator())};
}

[[noreturn]] void refuse_dependent(std::span<const std::size_t> elements) {
    std::string names;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        names += (i == 0 ? "" : i + 1 == elements.size() ? " and " : ", ") + std::to_string(elements[i]);
    }
    throw Error(ErrorCode::degenerate_simplex,
                elements.size() == 1 ? "element " + names + " of the frame is zero"
                                     : "the elements " + names + " of the frame are linearly dependent",
                Part::elements / elements.back());
}

/// Changes the coordinates of an argument for a frame in which `element`, whose coordinate at `place` is not
/// 0, replaces the element at `place`.
void exchange(Coordinates& argument, const Coordinates& element, std::size_t place) {
    const Rational own = argument[place] / element[place];
    for (std::size_t k = 0; k < argument.size(); ++k) argument[k] -= own * element[k];
    argument[place] = own;
}

bool is_unit(const Coordinates& tuple, std::size_t place) {
    for (std::size_t k = 0; k < tuple.size(); ++k) {
        if (tuple[k] != (k == place ? 1 : 0)) return false;
    }
    return true;
}

void require_elements(const NetShape& shape, std::size_t factor, std::span<const Coordinates> elements) {
    const std::size_t vertices = shape[factor].dimension + 1;
    const auto refuse = [&](std::size_t given, ErrorCode code, const std::string& what, const Place& place) {
        throw Error(code,
                    what + " must have length " + std::to_string(vertices) + ", not " + std::to_string(given),
                    place);
    };
    if (elements.size() != vertices) {
        refuse(elements.size(), ErrorCode::wrong_arity, "the list of elements of a frame", Part::elements);
    }
    for (std::size_t j = 0; j < elements.size(); ++j) {
        if (elements[j].size() == vertices) continue;
        refuse(elements[j].size(), ErrorCode::mismatched_dimensions, "element " + std::to_string(j),
               Part::elements / j);
    }
}

}  // namespace

BezierPatch with_frame(const BezierPatch& patch, std::size_t factor, std::span<const Coordinates> elements,
                       const Limits& limits) {
    require_elements(patch.shape(), factor, elements);
    const std::size_t vertices = elements.size();
    std::vector<Coordinates> remaining(elements.begin(), elements.end());
    std::vector<std::optional<std::size_t>> occupant(vertices);  // the element at each place
    std::vector<std::size_t> order;                              // the place of each element
    BezierPatch result = patch;
    for (std::size_t j = 0; j < vertices; ++j) {
        const Coordinates element = remaining[j];
        std::optional<std::size_t> place;
        std::vector<std::size_t> dependent;
        for (std::size_t k = 0; k < vertices; ++k) {
            if (element[k].is_zero()) continue;
            if (occupant[k]) {
                dependent.push_back(*occupant[k]);
            } else if (!place || k == j) {
                place = k;
            }
        }
        if (!place) {
            std::ranges::sort(dependent);
            dependent.push_back(j);
            refuse_dependent(dependent);
        }
        if (!is_unit(element, *place)) {
            result = with_vertices_replaced(result, factor, element, std::span(&*place, 1), limits).front();
            for (std::size_t i = j + 1; i < vertices; ++i) exchange(remaining[i], element, *place);
        }
        occupant[*place] = j;
        order.push_back(*place);
    }
    return std::ranges::is_sorted(order) ? result : permuted(result, factor, order);
}

std::vector<std::size_t> replaced_vertices(const Coordinates& point) {
    std::vector<std::size_t> vertices;
    for (std::size_t k = 0; k < point.size(); ++k) {
        if (!point[k].is_zero()) vertices.push_back(k);
    }
    return vertices;
}

std::vector<BezierPatch> subdivide(const BezierPatch& patch, std::size_t factor, const Coordinates& point,
                                   const Limits& limits) {
    const std::size_t vertices = patch.shape()[factor].dimension + 1;
    if (point.size() != vertices) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "a point of factor " + std::to_string(factor) + " has " + std::to_string(vertices) +
                        " barycentric coordinates, not " + std::to_string(point.size()),
                    Part::at);
    }
    within(Part::at, [&] { require_mass(point, 1, "the point to subdivide at"); });
    const std::vector<std::size_t> replaced = replaced_vertices(point);
    if (replaced.size() == 1 && vertices > 1) {
        throw Error(ErrorCode::degenerate_simplex,
                    "the point is vertex " + std::to_string(replaced.front()) + ", which divides nothing",
                    Part::at);
    }
    return with_vertices_replaced(patch, factor, point, replaced, limits);
}

// The pieces are walks of s steps from (0, m) to (m, s): in each step one of the two vertices advances by
// one, and the midpoint of the two is a vertex of the piece.
std::vector<std::vector<Coordinates>> midpoint_simplices(std::size_t dimension) {
    std::vector<std::vector<Coordinates>> simplices;
    for (std::size_t choice = 0; choice < std::size_t{1} << dimension; ++choice) {
        std::size_t first = 0;
        auto second = static_cast<std::size_t>(std::popcount(choice));
        auto& simplex = simplices.emplace_back();
        for (std::size_t step = 0;; ++step) {
            Coordinates& vertex = simplex.emplace_back(dimension + 1);
            vertex[first] += Rational(1, 2);
            vertex[second] += Rational(1, 2);
            if (step == dimension) break;
            ++((choice >> step & 1) != 0 ? first : second);
        }
    }
    return simplices;
}

std::vector<MidpointPiece> subdivide_at_midpoints(const BezierPatch& patch, std::size_t factor,
                                                  const Limits& limits) {
    const std::size_t dimension = patch.shape()[factor].dimension;
    require_within(dimension, 20, "numbers", "the dimension of a simplex to divide into 2^s pieces");
    require_within(patch.control_net().numbers().size(), limits.numbers >> dimension, "numbers",
                   "the number of coordinates of each of the 2^s pieces");
    std::vector<MidpointPiece> pieces;
    for (auto& elements : midpoint_simplices(dimension)) {
        BezierPatch piece = with_frame(patch, factor, elements, limits);
        pieces.push_back({std::move(piece), std::move(elements)});
    }
    return pieces;
}

}  // namespace blossom
