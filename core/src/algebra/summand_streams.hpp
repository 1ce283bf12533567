#pragma once

#include <blossom/rational/resource_budget.hpp>

#include <span>
#include <utility>
#include <vector>

#include "sparse_arithmetic.hpp"

/// Streams of the terms of polynomials, and sums of several streams.

namespace blossom::summand_streams {

/// Terms times one term, whose monomial is empty if it is 1.
struct Summand {
    const AlignedTerms* terms;
    const std::uint64_t* monomial;
    Integer coefficient;
};

/// The terms of a summand as a stream.
template <class Width>
class SummandStream {
public:
    SummandStream(const Width& width, const Summand& summand)
        : width_(width),
          summand_(summand),
          monomial_(summand.terms->monomials()),
          coefficient_(summand.terms->coefficients()),
          left_(summand.terms->size()),
          product_(width.monomial()),
          scaled_(!summand.coefficient.is_one()) {
        shift();
    }

    std::size_t left() const { return left_; }
    const std::uint64_t* monomial() const { return summand_.monomial ? product_.data() : monomial_; }
    Integer take() {
        Integer result = scaled_ ? *coefficient_ * summand_.coefficient : *coefficient_;
        monomial_ += width_.words();
        ++coefficient_;
        --left_;
        shift();
        return result;
    }

private:
    void shift() {
        if (summand_.monomial && left_ > 0) width_.add(monomial_, summand_.monomial, product_.data());
    }

    Width width_;
    const Summand& summand_;
    const std::uint64_t* monomial_;
    const Integer* coefficient_;
    std::size_t left_;
    typename Width::Monomial product_;
    bool scaled_;
};

/// Stored terms as a stream; their coefficients are moved out.
template <class Width>
class ConsumedStream {
public:
    ConsumedStream(const Width& width, SparseTerms& terms) : width_(width), terms_(terms) {}

    std::size_t left() const { return terms_.size() - next_; }
    const std::uint64_t* monomial() const { return terms_.monomials.data() + next_ * width_.words(); }
    Integer take() { return std::move(terms_.coefficients[next_++]); }

private:
    Width width_;
    SparseTerms& terms_;
    std::size_t next_ = 0;
};

/// Collects terms in descending order.
template <class Width>
class TermWriter {
public:
    TermWriter(const Width& width, std::size_t most) : width_(width) {
        terms_.monomials.resize(most * width.words());
        terms_.coefficients.reserve(most);
    }

    void append(const std::uint64_t* monomial, Integer&& coefficient) {
        width_.copy(monomial, terms_.monomials.data() + terms_.size() * width_.words());
        terms_.coefficients.push_back(std::move(coefficient));
    }
    template <class Stream>
    void append_next(Stream& stream) {
        width_.copy(stream.monomial(), terms_.monomials.data() + terms_.size() * width_.words());
        terms_.coefficients.push_back(stream.take());
    }
    SparseTerms finished() && {
        terms_.monomials.resize(terms_.size() * width_.words());
        return std::move(terms_);
    }

private:
    Width width_;
    SparseTerms terms_;
};

template <class Width, class Stream>
SparseTerms merged(const Width& width, Stream a, Stream b) {
    constexpr std::uint64_t words_of_term = 16;
    spend_work(words_of_term * (a.left() + b.left()));
    TermWriter<Width> writer(width, a.left() + b.left());
    auto monomial = width.monomial();
    while (a.left() > 0 && b.left() > 0) {
        const int order = width.compare(a.monomial(), b.monomial());
        if (order > 0) {
            writer.append_next(a);
        } else if (order < 0) {
            writer.append_next(b);
        } else {
            width.copy(a.monomial(), monomial.data());
            Integer coefficient = a.take();
            coefficient += b.take();
            if (!coefficient.is_zero()) writer.append(monomial.data(), std::move(coefficient));
        }
    }
    while (a.left() > 0) writer.append_next(a);
    while (b.left() > 0) writer.append_next(b);
    return std::move(writer).finished();
}

/// The sum of one or more summands, by halves.
template <class Width>
SparseTerms sum_of(const Width& width, std::span<const Summand> summands) {
    using Stream = SummandStream<Width>;
    if (summands.size() == 1) {
        Stream stream(width, summands[0]);
        TermWriter<Width> writer(width, stream.left());
        while (stream.left() > 0) writer.append_next(stream);
        return std::move(writer).finished();
    }
    if (summands.size() == 2) return merged(width, Stream(width, summands[0]), Stream(width, summands[1]));
    const std::size_t half = summands.size() / 2;
    SparseTerms a = sum_of(width, summands.first(half));
    SparseTerms b = sum_of(width, summands.subspan(half));
    return merged(width, ConsumedStream<Width>(width, a), ConsumedStream<Width>(width, b));
}

}  // namespace blossom::summand_streams
