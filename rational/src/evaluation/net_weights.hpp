#pragma once

// The weights of a net and its sums, as templates over a ring with the type Number, zero by default; one();
// add(to, number); and on rows of numbers scale(to, from, factor, count), add_multiple(to, from, factor,
// count) and dot(a, b, count).

#include <blossom/rational/net_sums.hpp>

#include <algorithm>

namespace blossom::net_weights {

/// C(degree + dimension, dimension), the number of indices of a net in memory.
inline std::size_t count_of(std::size_t dimension, std::size_t degree) {
    std::size_t count = 1;
    for (std::size_t i = 1; i <= dimension; ++i) {
        count *= degree + i;
        if (i > 1) count /= i;
    }
    return count;
}

/// The number of indices with i_0 = n - b. For a point, of dimension 0, there is only b = 0.
inline std::size_t block_size(const SimplexFactor& factor, std::size_t b) {
    if (factor.dimension == 0) return b == 0 ? 1 : 0;
    return count_of(factor.dimension - 1, b);
}

/// x^i for the indices i of a factor; block b holds those with i_0 = n - b. Without the power of x_0, block b
/// contains the monomials of degree b in the other variables: x_1 times all monomials of degree b - 1, then
/// x_2 times those without x_1, and so on; each time these are the end of the previous block.
template <class Ring>
void set_blocks(const Ring& ring, const SimplexFactor& factor, const typename Ring::Number* x,
                typename Ring::Number* monomials) {
    const auto [dimension, degree] = factor;
    *monomials++ = ring.one();
    for (std::size_t b = 1; b <= degree; ++b) {
        const auto* const before = monomials;
        for (std::size_t k = 1; k <= dimension; ++k) {
            const std::size_t count = count_of(dimension - k, b - 1);
            ring.scale(monomials, before - count, x[k], count);
            monomials += count;
        }
    }
}
/// The same with the power of x_0.
template <class Ring>
void set_monomials(const Ring& ring, const SimplexFactor& factor, const typename Ring::Number* x,
                   typename Ring::Number* monomials) {
    set_blocks(ring, factor, x, monomials);
    auto power = ring.one();
    auto* block = monomials + count_of(factor.dimension, factor.degree) - block_size(factor, factor.degree);
    for (std::size_t b = factor.degree; b-- > 0;) {
        block -= block_size(factor, b);
        ring.scale(&power, &power, x[0], 1);
        ring.scale(block, block, power, block_size(factor, b));
    }
}

/// The sum of the numbers of a net of one factor times its monomials, by Horner's rule in x_0 over the
/// blocks.
template <class Ring>
typename Ring::Number sum_of_blocks(const Ring& ring, const SimplexFactor& factor,
                                    const typename Ring::Number& x, const typename Ring::Number* net,
                                    const typename Ring::Number* blocks) {
    typename Ring::Number sum = net[0];
    for (std::size_t b = 1; b <= factor.degree; ++b) {
        net += block_size(factor, b - 1);
        blocks += block_size(factor, b - 1);
        ring.scale(&sum, &sum, x, 1);
        const auto next = ring.dot(net, blocks, block_size(factor, b));
        ring.add(&sum, next);
    }
    return sum;
}

/// product += form * polynomial for a homogeneous polynomial of this degree in dimension + 1 variables: a
/// factor of the first variable leaves the positions of the coefficients unchanged, any other moves each
/// block to the next.
template <class Ring>
void add_product(const Ring& ring, std::size_t dimension, std::size_t degree,
                 const typename Ring::Number* form, const typename Ring::Number* polynomial,
                 typename Ring::Number* product) {
    ring.add_multiple(product, polynomial, form[0], count_of(dimension, degree));
    if (dimension == 0) return;
    if (dimension == 1) return ring.add_multiple(product + 1, polynomial, form[1], degree + 1);
    for (std::size_t b = 0; b <= degree; ++b) {
        const std::size_t count = count_of(dimension - 1, b);
        product += count;
        add_product(ring, dimension - 1, b, form + 1, polynomial, product);
        polynomial += count;
    }
}

/// Multiplies the polynomial with the coefficients `weights` by a linear form; `room` is as long as the old
/// `weights`.
template <class Ring>
void multiply_by_form(const Ring& ring, std::size_t dimension, std::size_t degree,
                      const typename Ring::Number* form, typename Ring::Number* weights,
                      typename Ring::Number* room) {
    const std::size_t count = count_of(dimension, degree);
    std::copy(weights, weights + count, room);
    std::fill(weights, weights + count_of(dimension, degree + 1), typename Ring::Number{});
    add_product(ring, dimension, degree, form, room, weights);
}

/// The net of the first factor that remains when a net is summed with the weights of all other factors, which
/// end at `weights_end`; it is in `room` unless there are no other factors.
template <class Ring>
const typename Ring::Number* contracted_to_first(const Ring& ring, std::span<const std::size_t> counts,
                                                 const typename Ring::Number* net, std::size_t size,
                                                 const typename Ring::Number* weights_end,
                                                 typename Ring::Number* room) {
    for (std::size_t f = counts.size() - 1; f > 0; --f) {
        weights_end -= counts[f];
        size /= counts[f];
        for (std::size_t i = 0; i < size; ++i)
            room[i] = ring.dot(net + i * counts[f], weights_end, counts[f]);
        net = room;
    }
    return net;
}

}  // namespace blossom::net_weights
