#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/patch/net_bounds.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

namespace {

/// The least and the greatest control point; none where weights differ in sign or are 0.
std::optional<std::pair<Rational, Rational>> range_of(const BezierPatch& net) {
    std::vector<Rational> values;
    int sign = 0;
    for (const Coordinates& point : net.control_net().to_points()) {
        if (point.size() == 1) {
            values.push_back(point[0]);
            continue;
        }
        const int own = point[1].sign();
        if (own == 0 || own == -sign) return std::nullopt;
        sign = own;
        values.push_back(point[0] / point[1]);
    }
    const auto [least, greatest] = std::ranges::minmax_element(values);
    return std::pair(*least, *greatest);
}

/// A vertex of the domain at which the value is not positive.
std::optional<ValueAt> value_at_vertex(const PlacedPatch& piece) {
    const NetShape& shape = piece.patch.shape();
    std::vector<std::size_t> vertex(shape.factors());
    for (;;) {
        std::vector<MultiIndex> indices;
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            indices.emplace_back(shape[f].dimension + 1);
            indices.back()[vertex[f]] = shape[f].degree;
        }
        const Coordinates point = piece.patch.control_net()[shape.position_of(indices)];
        if (point.size() == 1 || !point[1].is_zero()) {
            ValueAt found{{}, point.size() == 1 ? point[0] : point[0] / point[1]};
            if (found.value.sign() <= 0) {
                for (std::size_t f = 0; f < shape.factors(); ++f)
                    found.at.push_back(piece.frames[f].vertices()[vertex[f]]);
                return found;
            }
        }
        std::size_t f = 0;
        while (f < shape.factors() && ++vertex[f] > shape[f].dimension) vertex[f++] = 0;
        if (f == shape.factors()) return std::nullopt;
    }
}

std::vector<PlacedPatch> divided_at_midpoints(const PlacedPatch& piece, const Limits& limits) {
    std::vector<PlacedPatch> parts{piece};
    for (std::size_t f = 0; f < piece.frames.size(); ++f) {
        std::vector<PlacedPatch> finer;
        for (const PlacedPatch& part : parts) {
            for (auto& [net, elements] : subdivide_at_midpoints(part.patch, f, limits)) {
                const auto vertex_of = [&](const Coordinates& element) {
                    return part.frames[f].combination(element);
                };
                std::vector<Coordinates> vertices = mapped(elements, vertex_of);
                PlacedPatch& made = finer.emplace_back(PlacedPatch{std::move(net), part.frames});
                made.frames[f] = BarycentricFrame(std::move(vertices));
            }
        }
        parts = std::move(finer);
    }
    return parts;
}

/// The pieces, and what is known of them so far.
class Bounding {
public:
    explicit Bounding(std::span<const PlacedPatch> pieces) : open_(pieces.begin(), pieces.end()) {}

    /// Looks at all pieces, and keeps those that do not settle the sign.
    void settle() {
        std::vector<PlacedPatch> unsettled;
        for (PlacedPatch& piece : open_) {
            const auto range = range_of(piece.patch);
            if (range && range->first.sign() > 0) {
                include(range);
                continue;
            }
            if (!result_.witness) result_.witness = value_at_vertex(piece);
            unsettled.push_back(std::move(piece));
        }
        open_ = std::move(unsettled);
    }
    bool is_settled() const { return open_.empty() || result_.witness; }
    /// Whether there is room for the parts of all pieces.
    bool has_room(const Limits& limits) const {
        std::size_t parts = 1;
        for (const SimplexFactor& factor : open_.front().patch.shape().list()) {
            if (factor.dimension > most_dimension || parts > limits.numbers) return false;
            parts <<= factor.dimension;
        }
        const std::size_t each = open_.front().patch.control_net().numbers().size();
        return parts <= limits.numbers / each / open_.size();
    }
    void divide(const Limits& limits) {
        std::vector<PlacedPatch> finer;
        for (const PlacedPatch& piece : open_)
            std::ranges::move(divided_at_midpoints(piece, limits), std::back_inserter(finer));
        open_ = std::move(finer);
    }
    NetBounds finish() && {
        if (result_.witness) {
            result_.positivity = Positivity::not_positive;
        } else if (open_.empty()) {
            result_.positivity = Positivity::positive;
        }
        for (const PlacedPatch& piece : open_) include(range_of(piece.patch));
        if (!bounded_) result_.lower = result_.upper = std::nullopt;
        return std::move(result_);
    }

private:
    static constexpr std::size_t most_dimension = 20;

    void include(const std::optional<std::pair<Rational, Rational>>& range) {
        ++result_.nets;
        bounded_ = bounded_ && range;
        if (!range) return;
        result_.lower = result_.lower ? std::min(*result_.lower, range->first) : range->first;
        result_.upper = result_.upper ? std::max(*result_.upper, range->second) : range->second;
    }

    std::vector<PlacedPatch> open_;
    NetBounds result_;
    bool bounded_ = true;
};

}  // namespace

NetBounds net_bounds(std::span<const PlacedPatch> pieces, std::size_t depth, const Limits& limits) {
    for (const PlacedPatch& piece : pieces) {
        if (piece.patch.dimension() <= 2) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "a map with " + std::to_string(piece.patch.dimension()) + " coordinates has no sign",
                    Part::map);
    }
    Bounding bounding(pieces);
    bounding.settle();
    for (std::size_t level = 0; level < depth && !bounding.is_settled() && bounding.has_room(limits);
         ++level) {
        bounding.divide(limits);
        bounding.settle();
    }
    return std::move(bounding).finish();
}

}  // namespace blossom
