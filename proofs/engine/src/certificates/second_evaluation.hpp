#pragma once

#include "second_reading.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// Both sides of a claim, and its hypotheses and assumptions, as elements of a field, by plain recursion over the tree.
///
/// A Field has `using Element = ...` (a regular type) and
///
///     Element number(const Rational&);
///     Element symbol(const std::string& name);   // asked for once a symbol and evaluation
///     Element bound(const std::string& name);    // asked for once a bound variable, case and call of hypotheses()
///     Element sum(const Element&, const Element&);
///     Element product(const Element&, const Element&);
///     Element negative(const Element&);
///     Element quotient(const Element&, const Element&);
///     Element power(const Element&, std::size_t);
///     Element derivative(const std::function<Element(const Element&)>&, const Element& at, std::size_t order);
///     std::vector<Element> coefficients(const std::function<Element(const Element&)>&, std::size_t degree);
///     bool is_zero(const Element&);
template <class Field>
class Evaluation {
public:
    using Element = typename Field::Element;

    /// `reading` and `field` must outlive the evaluation.
    Evaluation(const Reading& reading, const Case& which, Field& field);

    Element left();
    Element right();
    /// left - right == 0 for each case of each `given` line, in order.
    std::vector<std::pair<Element, Element>> hypotheses();
    /// The same for one line; bound variables are asked for anew with each call.
    std::vector<std::pair<Element, Element>> hypotheses(std::size_t line);
    /// left != right for each case of each `assume` line, in order.
    std::vector<std::pair<Element, Element>> assumptions();
};

}  // namespace blossom::proofs::second
