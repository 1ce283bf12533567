#include <blossom/rational/net_steps.hpp>
#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <bit>

#include "limb_ring.hpp"
#include "net_rings.hpp"
#include "net_weights.hpp"

namespace blossom {

namespace {

using net_weights::count_of;

/// raised += the net of degree `degree`, raised by one: block b is (degree + 1 - b) times the old block, plus
/// the previous block raised in the other variables.
template <class Ring>
void add_raised(const Ring& ring, std::size_t dimension, std::size_t degree, std::size_t behind,
                const typename Ring::Number* net, typename Ring::Number* raised) {
    if (dimension == 0) return ring.add_multiple(raised, net, ring.factor(degree + 1), behind);
    if (dimension == 1) {
        const std::size_t step = behind * ring.stride();
        for (std::size_t b = 0; b <= degree; ++b, net += step) {
            ring.add_multiple(raised, net, ring.factor(degree + 1 - b), behind);
            raised += step;
            ring.add_multiple(raised, net, ring.factor(b + 1), behind);
        }
        return;
    }
    const typename Ring::Number* before = net;
    for (std::size_t b = 0; b <= degree + 1; ++b) {
        const std::size_t size = count_of(dimension - 1, b) * behind;
        if (b <= degree) ring.add_multiple(raised, net, ring.factor(degree + 1 - b), size);
        if (b > 0) add_raised(ring, dimension - 1, b - 1, behind, before, raised);
        before = net;
        net += size * ring.stride();
        raised += size * ring.stride();
    }
}

/// folded += the contribution of all coordinates of the argument but the first to a step of de Casteljau's
/// algorithm from degree `degree`: block b of the result receives it from block b + 1.
template <class Ring>
void add_folded(const Ring& ring, std::size_t dimension, std::size_t degree, std::size_t behind,
                const typename Ring::Number* net, const typename Ring::Factor* argument,
                typename Ring::Number* folded) {
    if (dimension == 0) return;
    net += behind * ring.stride();
    if (dimension == 1) return ring.add_multiple(folded, net, argument[1], degree * behind);
    for (std::size_t b = 0; b < degree; ++b) {
        const std::size_t size = count_of(dimension - 1, b) * behind;
        ring.add_multiple(folded, net, argument[1], size);
        add_folded(ring, dimension - 1, b + 1, behind, net, argument + 1, folded);
        net += count_of(dimension - 1, b + 1) * behind * ring.stride();
        folded += size * ring.stride();
    }
}

/// Calls visit(from, to, count) for the entries of a net of degree `degree` whose index at the vertex is 0;
/// `to` is the position, in a net of degree `degree` + r, of the index with r at the vertex.
template <class Visit>
void each_opposite(std::size_t dimension, std::size_t degree, std::size_t vertex, std::size_t r,
                   std::size_t from, std::size_t to, const Visit& visit) {
    if (dimension == 0) {
        if (degree == 0) visit(from, to, 1);
        return;
    }
    if (vertex == 0) {
        const std::size_t before = degree == 0 ? 0 : count_of(dimension, degree - 1);
        visit(from + before, to + before, count_of(dimension - 1, degree));
        return;
    }
    for (std::size_t b = 0; b < r; ++b) to += count_of(dimension - 1, b);
    for (std::size_t b = 0; b <= degree; ++b) {
        each_opposite(dimension - 1, b, vertex - 1, r, from, to, visit);
        from += count_of(dimension - 1, b);
        to += count_of(dimension - 1, b + r);
    }
}

std::size_t words_for(std::size_t bits) { return bits / 64 + 1; }

template <class Ring>
std::vector<Integer> raised_in(const Ring& ring, const FactorNets& nets) {
    const auto [dimension, degree] = nets.factor;
    const std::size_t size = count_of(dimension, degree) * nets.behind;
    const std::size_t raised_size = count_of(dimension, degree + 1) * nets.behind;
    typename Ring::Room net(size * ring.stride());
    typename Ring::Room raised(raised_size * ring.stride());
    std::vector<Integer> numbers;
    numbers.reserve(nets.numbers.size() / size * raised_size);
    for (std::size_t begin = 0; begin < nets.numbers.size(); begin += size) {
        ring.read(nets.numbers.subspan(begin, size), net.data());
        std::fill_n(raised.data(), raised_size * ring.stride(), typename Ring::Number{});
        add_raised(ring, dimension, degree, nets.behind, net.data(), raised.data());
        for (std::size_t i = 0; i < raised_size; ++i)
            numbers.push_back(ring.integer(raised.data() + i * ring.stride()));
    }
    return numbers;
}

/// Bounds in bits on the numbers that take part in replacing vertices.
struct StepBits {
    StepBits(const FactorNets& nets, std::span<const Integer> entries, const Integer& scale)
        : net(greatest_bit_length(nets.numbers)), degree(nets.factor.degree) {
        Integer norm;
        for (const Integer& entry : entries) norm += abs(entry);
        argument = norm.bit_length();
        result = net + degree * std::max(argument, scale.bit_length());
    }

    std::size_t level(std::size_t r) const { return net + r * argument; }

    std::size_t net;
    std::size_t degree;
    std::size_t argument;  ///< of the sum of the absolute values of the entries
    std::size_t result;
};

void start_level(LimbRing& ring, const StepBits& bits, std::size_t r) {
    ring.set_width(words_for(bits.level(r == 0 ? 0 : r - 1)), words_for(bits.level(r)));
}
template <class Ring>
void start_level(Ring&, const StepBits&, std::size_t) {}

template <class Ring>
std::vector<std::vector<Integer>> replaced_in(Ring ring, const FactorNets& nets, const StepBits& bits,
                                              std::span<const Integer> entries, const Integer& scale,
                                              std::span<const std::size_t> vertices) {
    const auto [dimension, degree] = nets.factor;
    const std::size_t size = count_of(dimension, degree) * nets.behind;
    typename Ring::Room rooms[] = {typename Ring::Room(size * ring.stride()),
                                   typename Ring::Room(size * ring.stride())};
    auto* level = rooms[0].data();
    auto* folded = rooms[1].data();
    std::vector<typename Ring::Factor> argument;
    for (const Integer& entry : entries) argument.push_back(ring.factor(entry));
    std::vector<typename Ring::Power> powers{1};
    while (powers.size() <= degree) powers.push_back(powers.back() * ring.power(scale));
    std::vector<std::vector<Integer>> results(vertices.size(), std::vector<Integer>(nets.numbers.size()));
    for (std::size_t begin = 0; begin < nets.numbers.size(); begin += size) {
        start_level(ring, bits, 0);
        ring.read(nets.numbers.subspan(begin, size), level);
        for (std::size_t r = 0;; ++r) {
            const auto& power = powers[degree - r];
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                each_opposite(dimension, degree - r, vertices[i], r, 0, 0,
                              [&](std::size_t from, std::size_t to, std::size_t count) {
                                  const auto* number = level + from * nets.behind * ring.stride();
                                  Integer* result = results[i].data() + begin + to * nets.behind;
                                  for (std::size_t k = 0; k < count * nets.behind; ++k) {
                                      result[k] = ring.product(number, power);
                                      number += ring.stride();
                                  }
                              });
            }
            if (r == degree) break;
            spend_work(count_of(dimension, degree - r) * nets.behind * words_for(bits.level(r)));
            start_level(ring, bits, r + 1);
            ring.scale(folded, level, argument[0], count_of(dimension, degree - r - 1) * nets.behind);
            add_folded(ring, dimension, degree - r, nets.behind, level, argument.data(), folded);
            std::swap(level, folded);
        }
    }
    return results;
}

}  // namespace

std::vector<Integer> raised_by_one(const FactorNets& nets) {
    const std::size_t bits =
        greatest_bit_length(nets.numbers) + static_cast<std::size_t>(std::bit_width(nets.factor.degree + 1));
    spend_work(nets.numbers.size() * (nets.factor.dimension + 1) * words_for(bits));
    if (bits < 64) return raised_in(WordRing<std::uint64_t>(), nets);
    if (bits < 128) return raised_in(WordRing<UInt128>(), nets);
    return raised_in(LimbRing(words_for(bits)), nets);
}

std::vector<std::vector<Integer>> with_vertices_replaced(const FactorNets& nets,
                                                         std::span<const Integer> entries,
                                                         const Integer& scale,
                                                         std::span<const std::size_t> vertices) {
    const StepBits bits(nets, entries, scale);
    if (bits.result < 64) return replaced_in(WordRing<std::uint64_t>(), nets, bits, entries, scale, vertices);
    if (bits.result < 128) return replaced_in(WordRing<UInt128>(), nets, bits, entries, scale, vertices);
    return replaced_in(LimbRing(words_for(bits.level(bits.degree))), nets, bits, entries, scale, vertices);
}

}  // namespace blossom
