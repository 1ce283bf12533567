// The NURBS meshes of MFEM, version 1.0: a text with the topology of the patches, and then either the patches
// one by one, in whose points the first direction runs fastest, or the knot vectors of the edges and one list
// of points for the whole mesh: those of vertices, of edges, of faces and of the inside of patches.
// Source: MFEM, mesh/nurbs.cpp and mesh/mesh.cpp.

#include <fmt/format.h>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "doubles.hpp"
#include "foreign_formats.hpp"

namespace blossom::protocol {

namespace {

/// The words of a text, without comments.
class MeshWords {
public:
    MeshWords(std::string_view text, Floats floats, const Limits& limits)
        : text_(text), floats_(floats), limits_(limits) {
        skip();
    }

    [[noreturn]] void fail(std::size_t place, const std::string& message,
                           ErrorCode code = ErrorCode::syntax) const {
        const auto line = std::ranges::count(text_.substr(0, place), '\n') + 1;
        throw Error(code, fmt::format("line {}: {}", line, message), {}, place);
    }

    std::size_t place() const { return at_; }
    /// Of the word before.
    std::size_t last() const { return last_; }
    bool at_end() const { return at_ == text_.size(); }

    std::string_view word() {
        if (at_end()) fail(at_, "the file ends too early");
        last_ = at_;
        at_ = std::min(text_.find_first_of(blanks, at_), text_.size());
        const std::string_view found = text_.substr(last_, at_ - last_);
        skip();
        return found;
    }
    void keyword(std::string_view wanted) {
        const std::string_view found = word();
        if (found != wanted) fail(last_, fmt::format("expected {}, found {}", wanted, quoted(found)));
    }
    std::size_t count() {
        const std::string_view digits = word();
        std::size_t value = 0;
        for (const char digit : digits) {
            if (digit < '0' || digit > '9') fail(last_, "expected a count, found " + quoted(digits));
            value = 10 * value + static_cast<std::size_t>(digit - '0');
            if (value > limits_.numbers) fail(last_, quoted(digits) + " is too large a count");
        }
        return value;
    }
    std::size_t count_below(std::size_t end, std::string_view what) {
        const std::size_t value = count();
        if (value < end) return value;
        fail(last_, fmt::format("{} {} does not exist: there are {}", what, value, end),
             ErrorCode::mismatched_dimensions);
    }
    Rational number() {
        std::string_view digits = word();
        if (digits.starts_with('+')) digits.remove_prefix(1);
        try {
            return floats_ == Floats::decimal ? parse_rational(digits, limits_) : read_double(Json(digits));
        } catch (const Error& error) {
            fail(last_, error.message(), error.code());
        }
    }

private:
    static constexpr std::string_view blanks = " \t\r\n\f";

    void skip() {
        while ((at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size())) < text_.size() &&
               text_[at_] == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
    }

    std::string_view text_;
    Floats floats_;
    const Limits& limits_;
    std::size_t at_ = 0;
    std::size_t last_ = 0;
};

using Vertices = std::vector<std::size_t>;

/// The position of corner `i` of a segment, square or cube, as MFEM numbers them: 0 or 1 in each direction.
std::array<std::size_t, 3> corner_position(std::size_t i) {
    return {i % 4 == 1 || i % 4 == 2 ? std::size_t{1} : 0, i % 4 / 2, i / 4};
}

constexpr std::size_t geometries[] = {0, 1, 3, 5};  ///< of points, segments, squares and cubes

/// Corners of the edges of a segment, square or cube, by their direction.
std::vector<std::array<std::size_t, 2>> edges_along(std::size_t direction, std::size_t directions) {
    constexpr std::array<std::size_t, 2> all[3][4] = {
        {{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    const std::size_t count = std::size_t{1} << (directions - 1);
    return {all[direction], all[direction] + count};
}

/// Corners of the sides of a square or cube.
std::vector<Vertices> sides(std::size_t directions) {
    if (directions == 1) return {{0}, {1}};
    if (directions == 2) return {{0, 1}, {2, 3}, {3, 0}, {1, 2}};
    return {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
}

/// Points of one list that belong to an edge, a face or the inside of a patch.
struct PointBlock {
    std::size_t begin = 0;
    /// A vertex of it and its neighbours, along which the indices run, the fastest first.
    std::size_t origin = 0;
    Vertices axes;
};

struct DirectionKnots {
    std::size_t degree = 0;
    std::size_t points = 0;
    std::vector<Rational> knots;
    std::size_t place = 0;  ///< in the text
};

class MeshReader {
public:
    MeshReader(std::string_view text, Floats floats, const Limits& limits)
        : words_(text, floats, limits), limits_(limits) {}

    std::vector<ForeignSpline> read() {
        read_header();
        read_topology();
        const std::string_view section = words_.word();
        if (section == "patches") {
            for (std::size_t p = 0; p < patches_.size(); ++p) read_patch(p);
        } else if (section == "knotvectors") {
            read_common_points();
        } else {
            words_.fail(words_.last(), "expected patches or knotvectors, found " + quoted(section));
        }
        return std::move(splines_);
    }

private:
    struct Edge {
        std::size_t knots;
        std::size_t from;
        std::size_t to;
        std::size_t place;
    };

    void read_header() {
        for (const char* wanted : {"MFEM", "NURBS"}) words_.keyword(wanted);
        const std::size_t place = words_.place();
        if (words_.word() != "mesh" || !words_.word().starts_with("v1.")) {
            words_.fail(place, "only NURBS meshes of version 1 whose patches share whole sides are read",
                        ErrorCode::wrong_kind);
        }
    }

    void read_topology() {
        words_.keyword("dimension");
        directions_ = words_.count();
        if (directions_ == 0 || directions_ > 3) {
            words_.fail(words_.last(), "the dimension of a mesh is 1, 2 or 3", ErrorCode::wrong_kind);
        }
        words_.keyword("elements");
        patches_ = read_elements(directions_);
        words_.keyword("boundary");
        const std::vector<Vertices> boundary = read_elements(directions_ - 1);
        words_.keyword("edges");
        const std::size_t count = words_.count();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t place = words_.place();
            const std::size_t knots = words_.count();
            const std::size_t from = words_.count();
            edges_.push_back({knots, from, words_.count(), place});
        }
        words_.keyword("vertices");
        vertices_ = words_.count();
        for (const Vertices& element : patches_) require_vertices(element);
        for (const Vertices& element : boundary) require_vertices(element);
        for (const Edge& edge : edges_) require_vertices({edge.from, edge.to});
    }

    std::vector<Vertices> read_elements(std::size_t dimension) {
        std::vector<Vertices> elements;
        const std::size_t count = words_.count();
        for (std::size_t e = 0; e < count; ++e) {
            words_.word();  // the attribute
            if (words_.count() != geometries[dimension]) {
                words_.fail(words_.last(),
                            fmt::format("elements of dimension {} have the geometry {}", dimension,
                                        geometries[dimension]),
                            ErrorCode::wrong_kind);
            }
            elements.emplace_back();
            for (std::size_t i = 0; i < std::size_t{1} << dimension; ++i)
                elements.back().push_back(words_.count());
        }
        return elements;
    }

    void require_vertices(const Vertices& element) const {
        for (const std::size_t vertex : element) {
            if (vertex < vertices_) continue;
            words_.fail(words_.last(),
                        fmt::format("there are {} vertices, and none of number {}", vertices_, vertex),
                        ErrorCode::mismatched_dimensions);
        }
    }

    DirectionKnots read_knots() {
        DirectionKnots direction;
        direction.place = words_.place();
        direction.degree = words_.count();
        require_within(direction.degree, limits_.degree, "degree", "the degree");
        direction.points = words_.count();
        for (std::size_t i = 0; i < direction.points + direction.degree + 1; ++i)
            direction.knots.push_back(words_.number());
        return direction;
    }

    Rational read_weight_of_point() {
        Rational weight = words_.number();
        if (weight.sign() > 0) return weight;
        words_.fail(words_.last(), "the weight is " + to_string(weight) + ", and those of a mesh are above 0",
                    ErrorCode::zero_weight);
    }

    void read_patch(std::size_t p) {
        words_.keyword("knotvectors");
        if (words_.count() != directions_) {
            words_.fail(words_.last(), fmt::format("patch {} has {} directions", p, directions_),
                        ErrorCode::mismatched_dimensions);
        }
        std::vector<DirectionKnots> knots;
        std::size_t size = 1;
        for (std::size_t d = 0; d < directions_; ++d) {
            knots.push_back(read_knots());
            if (__builtin_mul_overflow(size, knots.back().points, &size)) size = limits_.numbers + 1;
            require_within(size, limits_.numbers, "numbers", "the count of control points");
        }
        words_.keyword("dimension");
        const std::size_t dimension = words_.count();
        const std::string_view kind = words_.word();
        const bool homogeneous = kind == "controlpoints" || kind == "controlpoints_homogeneous";
        if (!homogeneous && kind != "controlpoints_cartesian") {
            words_.fail(words_.last(),
                        "expected controlpoints or controlpoints_cartesian, found " + quoted(kind));
        }
        std::vector<Coordinates> points;
        std::vector<Rational> weights;
        for (std::size_t i = 0; i < size; ++i) {
            Coordinates point;
            for (std::size_t j = 0; j < dimension; ++j) point.push_back(words_.number());
            weights.push_back(read_weight_of_point());
            if (homogeneous) {
                for (Rational& coordinate : point) coordinate = coordinate / weights.back();
            }
            points.push_back(std::move(point));
        }
        add_spline(knots, std::move(points), std::move(weights), homogeneous);
    }

    /// Weights that are all 1 are left out.
    void add_spline(const std::vector<DirectionKnots>& knots, std::vector<Coordinates> points,
                    std::vector<Rational> weights, bool homogeneous) {
        SplineNumbers numbers;
        for (const DirectionKnots& direction : knots) {
            numbers.degrees.push_back(direction.degree);
            numbers.knots.push_back(direction.knots);
            numbers.counts.push_back(direction.points);
        }
        numbers.points = std::move(points);
        const bool rational =
            std::ranges::any_of(weights, [](const Rational& weight) { return weight != Rational(1); });
        if (rational) numbers.weights = std::move(weights);
        try {
            NumberPlaces places{.degrees = std::vector<Place>(directions_),
                                .knots = std::vector<Place>(directions_),
                                .order = first_fastest(directions_)};
            ForeignSpline spline = foreign_spline(std::move(numbers), std::move(places));
            spline.map.form.homogeneous = rational && homogeneous;
            spline.places = {};
            splines_.push_back(std::move(spline));
        } catch (const Error& error) {
            words_.fail(knots.front().place, error.message(), error.code());
        }
    }

    /// The knots of all edges, and one list of points.
    void read_common_points() {
        std::vector<DirectionKnots> knots;
        const std::size_t count = words_.count();
        for (std::size_t i = 0; i < count; ++i) knots.push_back(read_knots());
        for (Edge& edge : edges_) {
            if (edge.knots >= count) {
                words_.fail(
                    edge.place,
                    fmt::format("there are {} knot vectors, and none of number {}", count, edge.knots),
                    ErrorCode::mismatched_dimensions);
            }
        }
        std::vector<std::vector<DirectionKnots>> of_patches;
        for (const Vertices& patch : patches_) of_patches.push_back(knots_of_patch(patch, knots));
        const std::size_t size = number_points(of_patches);
        require_within(size, limits_.numbers, "numbers", "the count of control points");
        std::vector<Rational> weights(size, Rational(1));
        const std::string_view section = words_.word();
        if (section == "weights") {
            for (Rational& weight : weights) weight = read_weight_of_point();
        } else if (section != "unitweights" && section != "autoweights") {
            words_.fail(words_.last(),
                        "only meshes without refinement, spacing and periodic points are read: expected "
                        "weights, found " +
                            quoted(section),
                        ErrorCode::wrong_kind);
        }
        const std::vector<Coordinates> points = read_nodes(size);
        for (std::size_t p = 0; p < patches_.size(); ++p) {
            std::vector<Coordinates> own;
            std::vector<Rational> own_weights;
            for (const std::size_t i : points_of_patch(p, of_patches[p])) {
                own.push_back(points[i]);
                own_weights.push_back(weights[i]);
            }
            add_spline(of_patches[p], std::move(own), std::move(own_weights), false);
        }
    }

    std::vector<Coordinates> read_nodes(std::size_t size) {
        words_.keyword("FiniteElementSpace");
        words_.keyword("FiniteElementCollection:");
        if (!words_.word().starts_with("NURBS"))
            words_.fail(words_.last(), "the nodes of a NURBS mesh are NURBS", ErrorCode::wrong_kind);
        words_.keyword("VDim:");
        const std::size_t dimension = words_.count();
        words_.keyword("Ordering:");
        const bool by_point = words_.count() == 1;
        if (dimension == 0) words_.fail(words_.last(), "points have at least one coordinate");
        require_numbers(size, dimension, limits_);
        std::vector<Coordinates> points(size, Coordinates(dimension));
        for (std::size_t i = 0; i < size * dimension; ++i) {
            (by_point ? points[i / dimension][i % dimension] : points[i % size][i / size]) = words_.number();
        }
        return points;
    }

    /// An edge between two vertices. Errors: `incomplete_net` if there is none.
    const Edge& edge_between(std::size_t one, std::size_t other) const {
        const auto found = std::ranges::find_if(edges_, [&](const Edge& edge) {
            return std::minmax(edge.from, edge.to) == std::minmax(one, other);
        });
        if (found != edges_.end()) return *found;
        words_.fail(words_.last(), fmt::format("the edge between vertices {} and {} is missing", one, other),
                    ErrorCode::incomplete_net);
    }

    static bool is_symmetric(const std::vector<Rational>& knots) {
        for (std::size_t i = 0; i < knots.size(); ++i) {
            if (knots[i] + knots[knots.size() - 1 - i] != knots.front() + knots.back()) return false;
        }
        return true;
    }

    /// Its knots in each direction. Parallel edges must have the same; where an edge runs the other way, only
    /// symmetric knots say the same in both.
    std::vector<DirectionKnots> knots_of_patch(const Vertices& patch,
                                               const std::vector<DirectionKnots>& knots) const {
        std::vector<DirectionKnots> own;
        for (std::size_t d = 0; d < directions_; ++d) {
            const auto along = edges_along(d, directions_);
            const Edge& first = edge_between(patch[along[0][0]], patch[along[0][1]]);
            for (const auto& [from, to] : along) {
                const Edge& edge = edge_between(patch[from], patch[to]);
                if (edge.knots != first.knots) {
                    words_.fail(edge.place,
                                fmt::format("parallel edges have one knot vector, and these have {} and {}",
                                            first.knots, edge.knots),
                                ErrorCode::bad_knots);
                }
                const bool forward = edge.from == patch[from] && edge.from < edge.to;
                if (forward || from != along[0][0] || is_symmetric(knots[edge.knots].knots)) continue;
                words_.fail(edge.place,
                            "the edge runs against its patch or from a greater to a smaller vertex, and its "
                            "knots are not symmetric; the form with patches states the direction",
                            ErrorCode::wrong_kind);
            }
            own.push_back(knots[first.knots]);
            if (own.back().points < 2)
                words_.fail(own.back().place, "an edge has at least 2 control points",
                            ErrorCode::wrong_arity);
            if (directions_ == 1 && own.back().points > 3) {
                words_.fail(
                    own.back().place,
                    "the order of the points inside a segment is only certain in the form with patches",
                    ErrorCode::wrong_kind);
            }
        }
        return own;
    }

    static Vertices sorted(Vertices vertices) {
        std::ranges::sort(vertices);
        return vertices;
    }

    /// Gives the points of vertices, edges, faces and patches their places, and answers their number.
    std::size_t number_points(const std::vector<std::vector<DirectionKnots>>& of_patches) {
        std::size_t size = vertices_;
        const auto add = [&](const Vertices& corners, PointBlock block, std::size_t points) {
            block.begin = size;
            if (!blocks_.try_emplace(sorted(corners), std::move(block)).second) return;
            size += points;
            require_within(size, limits_.numbers, "numbers", "the count of control points");
        };
        const auto inner = [](const DirectionKnots& direction) { return direction.points - 2; };
        if (directions_ > 1) {
            std::map<Vertices, std::size_t> lengths;
            for (std::size_t p = 0; p < patches_.size(); ++p) {
                for (std::size_t d = 0; d < directions_; ++d) {
                    for (const auto& [from, to] : edges_along(d, directions_))
                        lengths[sorted({patches_[p][from], patches_[p][to]})] = inner(of_patches[p][d]);
                }
            }
            for (const Edge& edge : edges_) {
                const auto [low, high] = std::minmax(edge.from, edge.to);
                const auto length = lengths.find({low, high});
                if (length == lengths.end())
                    words_.fail(edge.place, "no patch has this edge", ErrorCode::mismatched_dimensions);
                add({low, high}, {.origin = low, .axes = {high}}, length->second);
            }
        }
        if (directions_ == 3) {
            for (std::size_t p = 0; p < patches_.size(); ++p) {
                for (const Vertices& side : sides(3)) {
                    Vertices corners;
                    for (const std::size_t corner : side) corners.push_back(patches_[p][corner]);
                    const std::size_t u = direction_between(side[0], side[1]);
                    const std::size_t v = direction_between(side[0], side[3]);
                    add(corners, {.origin = corners[0], .axes = {corners[1], corners[3]}},
                        inner(of_patches[p][u]) * inner(of_patches[p][v]));
                }
            }
        }
        for (std::size_t p = 0; p < patches_.size(); ++p) {
            const Vertices& patch = patches_[p];
            PointBlock block{.origin = patch[0], .axes = {}};
            std::size_t points = 1;
            constexpr std::size_t neighbours[] = {1, 3, 4};
            for (std::size_t d = 0; d < directions_; ++d) {
                block.axes.push_back(patch[neighbours[d]]);
                points *= inner(of_patches[p][d]);
            }
            add(patch, std::move(block), points);
        }
        return size;
    }

    /// The direction between neighbouring corners.
    static std::size_t direction_between(std::size_t one, std::size_t other) {
        const auto a = corner_position(one);
        const auto b = corner_position(other);
        std::size_t direction = 0;
        while (a[direction] == b[direction]) ++direction;
        return direction;
    }

    /// For each point of a patch, the first direction running fastest, its place in the list of all.
    std::vector<std::size_t> points_of_patch(std::size_t p, const std::vector<DirectionKnots>& knots) const {
        std::vector<std::size_t> places;
        std::array<std::size_t, 3> index{};
        std::array<std::size_t, 3> counts{1, 1, 1};
        for (std::size_t d = 0; d < directions_; ++d) counts[d] = knots[d].points;
        for (index[2] = 0; index[2] < counts[2]; ++index[2]) {
            for (index[1] = 0; index[1] < counts[1]; ++index[1]) {
                for (index[0] = 0; index[0] < counts[0]; ++index[0])
                    places.push_back(place_of(patches_[p], counts, index));
            }
        }
        return places;
    }

    std::size_t place_of(const Vertices& patch, const std::array<std::size_t, 3>& counts,
                         const std::array<std::size_t, 3>& index) const {
        // The corners of the vertex, edge, face or cube that the point is inside of.
        Vertices corners;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const auto position = corner_position(i);
            bool is_corner = true;
            for (std::size_t d = 0; d < directions_; ++d) {
                const bool at_begin = index[d] == 0;
                const bool at_end = index[d] + 1 == counts[d];
                if ((at_begin || at_end) && position[d] != (at_end ? 1U : 0U)) is_corner = false;
            }
            if (is_corner) corners.push_back(i);
        }
        if (corners.size() == 1) return patch[corners.front()];
        Vertices own;
        for (const std::size_t corner : corners) own.push_back(patch[corner]);
        const PointBlock& block = blocks_.at(sorted(own));
        const auto corner_of = [&](std::size_t vertex) {
            return *std::ranges::find(corners, vertex, [&](std::size_t corner) { return patch[corner]; });
        };
        const std::size_t origin = corner_of(block.origin);
        std::size_t place = 0;
        for (std::size_t a = block.axes.size(); a-- > 0;) {
            const std::size_t d = direction_between(origin, corner_of(block.axes[a]));
            const std::size_t inner = counts[d] - 2;
            const std::size_t along = index[d] - 1;
            place = place * inner + (corner_position(origin)[d] == 0 ? along : inner - 1 - along);
        }
        return block.begin + place;
    }

    MeshWords words_;
    const Limits& limits_;
    std::size_t directions_ = 0;
    std::size_t vertices_ = 0;
    std::vector<Vertices> patches_;
    std::vector<Edge> edges_;
    std::map<Vertices, PointBlock> blocks_;  ///< by their sorted corners
    std::vector<ForeignSpline> splines_;
};

std::vector<ForeignSpline> read_mfem(const Json& document, Floats floats, const Limits& limits) {
    return MeshReader(read_text(document), floats, limits).read();
}

/// Errors: `bad_knots` unless the map begins and ends with control points.
void require_clamped(const Map& map) {
    for (const KnotVector& knots : knots_of(map)) {
        const bool clamped = knots.degree() > 0 && knots[0] == knots[knots.degree()] &&
                             knots[knots.size() - 1] == knots[knots.size() - 1 - knots.degree()];
        if (clamped) continue;
        throw Error(
            ErrorCode::bad_knots,
            "a mesh has knots of degree at least 1 whose first and last occur degree + 1 times; clamp makes "
            "them so");
    }
}

/// "1 2 3\n"
std::string line_of(const auto& items) { return fmt::format("{}\n", fmt::join(items, " ")); }

/// The vertices of a patch that has its own, for its corners.
Vertices own_vertices(std::size_t patch, std::size_t directions, const Vertices& corners) {
    return mapped(corners, [&](std::size_t corner) { return (patch << directions) + corner; });
}

std::string patch_text(const Map& map) {
    const std::size_t directions = knots_of(map).size();
    const WrittenSpline written = written_spline(map, first_fastest(directions));
    std::string text = fmt::format("\nknotvectors\n{}\n", directions);
    const auto number = [](const Json& value) { return value.number()->text; };
    for (std::size_t d = 0; d < directions; ++d) {
        text += fmt::format("{} {} ", written.degrees[d], written.counts[d]) +
                line_of(mapped(written.knots[d], number));
    }
    text += fmt::format("\ndimension\n{}\n\ncontrolpoints_cartesian\n", written.dimension);
    for (std::size_t i = 0; i < written.points.size(); ++i) {
        std::vector<std::string> numbers = mapped(*written.points[i].array(), number);
        numbers.push_back(written.weights.empty() ? "1" : number(written.weights[i]));
        text += line_of(numbers);
    }
    return text;
}

/// Each patch has vertices, edges and knots of its own.
Json write_mfem(const std::vector<Map>& splines) {
    if (splines.empty()) throw Error(ErrorCode::wrong_arity, "a mesh has at least one patch");
    const std::size_t directions = knots_of(splines.front()).size();
    if (directions > 3) {
        throw Error(ErrorCode::wrong_kind,
                    fmt::format("the dimension of a mesh is 1, 2 or 3, and this map has {}", directions));
    }
    std::string elements, boundary, edges, patches;
    std::size_t sides_count = 0, edges_count = 0;
    for (std::size_t p = 0; p < splines.size(); ++p) {
        const Map& map = splines[p];
        require_clamped(map);
        if (knots_of(map).size() != directions || point_dimension(map) != point_dimension(splines.front())) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "the patches of a mesh have one dimension, and so have their points");
        }
        Vertices corners(std::size_t{1} << directions);
        for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = i;
        elements +=
            fmt::format("1 {} ", geometries[directions]) + line_of(own_vertices(p, directions, corners));
        for (const Vertices& side : sides(directions)) {
            boundary +=
                fmt::format("1 {} ", geometries[directions - 1]) + line_of(own_vertices(p, directions, side));
            ++sides_count;
        }
        for (std::size_t d = 0; d < directions; ++d) {
            for (const auto& [from, to] : edges_along(d, directions)) {
                edges +=
                    fmt::format("{} ", p * directions + d) + line_of(own_vertices(p, directions, {from, to}));
                ++edges_count;
            }
        }
        patches += patch_text(map);
    }
    return fmt::format(
        "MFEM NURBS mesh "
        "v1.0\n\ndimension\n{}\n\nelements\n{}\n{}\nboundary\n{}\n{}\nedges\n{}\n{}\nvertices\n{}\n\n"
        "patches\n{}",
        directions, splines.size(), elements, sides_count, boundary, edges_count, edges,
        splines.size() << directions, patches);
}

}  // namespace

constinit const ForeignFormat mfem_format{
    .name = "mfem", .read = read_mfem, .write = write_mfem, .weights = true, .text = true};

}  // namespace blossom::protocol
