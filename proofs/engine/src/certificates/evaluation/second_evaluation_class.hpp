#pragma once

#include "certificates/reading/second_reading.hpp"
#include "second_counting.hpp"
#include "second_maps.hpp"

#include <blossom/rational/error.hpp>

#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace blossom::proofs::second {

/// Both sides of a claim, its hypotheses and its assumptions as elements of a field, by recursion over the
/// tree.
///
/// A Field has `using Element = ...`, a regular type, and these members:
///
/// - `number(Rational)`, `symbol(name)` and `bound(name)` give elements. Each symbol is requested once per
/// evaluation, each bound variable once per case and call of `hypotheses()`;
/// - `sum(a, b)`, `product(a, b)`, `negative(a)`, `quotient(a, b)` and `power(a, exponent)`;
/// - `derivative(f, at, order)` of a function of an element;
/// - `coefficients(f, degree)`: the coefficients of the polynomial f, lowest first;
/// - `is_zero(a)`.
///
/// After an exception from the field or the evaluation, the evaluation may only be destroyed.
template <class Field>
class Evaluation {
public:
    using Element = typename Field::Element;

    /// `reading`, `which` and `field` must outlive the evaluation.
    Evaluation(const Reading& reading, const Case& which, Field& field);

    Element left();
    Element right();
    /// left - right == 0 for each case of each line `given`, in order.
    std::vector<std::pair<Element, Element>> hypotheses();
    /// The same for one line; each call requests bound variables again.
    std::vector<std::pair<Element, Element>> hypotheses(std::size_t line);
    /// left != right for each case of each line `assume`, in order.
    std::vector<std::pair<Element, Element>> assumptions();

private:
    /// Coordinates and mass; `unit_mass` if the syntax shows that the mass is 1.
    struct Geometric {
        std::vector<Element> coordinates;
        Element mass;
        bool unit_mass = false;
    };
    using Value = std::variant<Element, Geometric>;
    using Key = std::vector<long long>;  ///< indices, then the position of the name or of the abbreviation
    using Function = std::function<Element(const Element&)>;
    struct Repeated {
        Geometric argument;
        std::size_t count = 0;
    };
    /// Results that depend on the values of free symbols and are worth keeping.
    struct Known {
        std::map<Key, Value> abbreviations;
        std::map<std::uint32_t, std::vector<Element>> coefficients;  ///< of maps
    };

    // Numbers: second_evaluation_numbers.hpp.
    Element number(NodeId id, Scope& scope);
    Element number_of_form(const Node& node, Scope& scope);
    Element name_value(const Node& node, Scope& scope);
    Element terms(const Node& node, Scope& scope);
    Element factors(const Node& node, Scope& scope);
    Element power(const Node& node, Scope& scope);
    Element iteration(const Node& node, Scope& scope);
    Element bernstein(const Node& node, Scope& scope);
    Element determinant(const Node& node, Scope& scope);
    Element determinant_of(const std::vector<std::vector<Element>>& matrix);
    Element basis(const Node& node, Scope& scope);
    std::optional<Element> basis_function(const Node& node, long long j, long long degree, long long span,
                                          const Element& at);

    // Points and names: second_evaluation_points.hpp.
    Geometric geometric(NodeId id, Scope& scope);
    Geometric geometric_of_form(const Node& node, Scope& scope);
    Geometric geometric_terms(const Node& node, Scope& scope);
    Geometric geometric_factors(const Node& node, Scope& scope);
    Geometric geometric_iteration(const Node& node, Scope& scope);
    Geometric point_of_number(Element coordinate);
    Geometric scaled(Geometric value, const Element& factor);
    void add_to(Geometric& total, const Geometric& term, bool subtract, const Node& node);
    Geometric declared_value(const Declaration& declaration, const std::string& name);
    std::optional<std::size_t> dimension(NodeId id, const Scope& scope, std::size_t depth);
    Value member(const Node& node, const Key& indices);
    Value abbreviation(const Node& node, const Key& indices);
    Value declared_member(const Node& node, std::uint32_t declaration, const Key& indices);
    Element symbol(std::uint32_t name, const Key& indices);

    // Maps: second_evaluation_maps.hpp and second_evaluation_nets.hpp.
    const MapShape& shape(std::uint32_t map);
    const std::vector<Element>& coefficients(std::uint32_t map);
    std::vector<Element> find_coefficients(std::uint32_t map);
    std::vector<Element> free_coefficients(const MapDeclaration& map, const MapShape& shape);
    std::vector<Element> raised_coefficients(const MapDeclaration& map, const MapShape& shape);
    std::vector<Element> net_coefficients(const MapDeclaration& map, const MapShape& shape);
    /// The barycentric coordinates as linear forms in the coordinates and, last, the mass.
    std::vector<std::vector<Element>> net_forms(const MapDeclaration& map, std::size_t dimension);
    Element net_value(const MapDeclaration& map, const Key& indices);
    std::vector<Element> polynomial_coefficients(const MapDeclaration& map, const MapShape& shape);
    /// The coefficients with respect to the variables from `variable` on, at the values in `scope` of the
    /// previous ones.
    std::vector<Element> coefficients_from(const MapDeclaration& map, const MapShape& shape,
                                           std::size_t variable, std::size_t degree, Scope& scope);
    Element map_value(const Node& node, Scope& scope);
    Element blossom(const Node& node, Scope& scope);
    std::vector<Geometric> map_arguments(const Node& node, std::size_t first, Scope& scope);
    std::vector<Repeated> expand(const Node& node, std::size_t first, std::size_t last, Scope& scope);
    void expand_run(const Node& run, std::vector<Repeated>& found, Scope& scope);
    std::vector<Element> value_weights(const Direction& direction, const Geometric& at);
    std::vector<Element> blossom_weights(const Direction& direction, const std::vector<Repeated>& arguments,
                                         std::size_t offset);
    /// The sum over all exponents of the coefficient times the weights of the directions.
    Element contract(std::uint32_t map, const std::vector<std::vector<Element>>& weights);
    void require_dimension(const Geometric& value, std::size_t dimension, std::size_t offset) const;
    bool has_unit_mass(const Geometric& value);

    // Derivatives: second_evaluation_derivatives.hpp.
    Element derivative(const Node& node, Scope& scope);
    Element map_derivative(const Node& node, Scope& scope);
    Element directional_derivative(const Node& node, Scope& scope);
    std::vector<Element> derivative_weights(const Direction& direction, const Geometric& at,
                                            std::size_t order, std::size_t offset);

    // Lines: second_evaluation_lines.hpp.
    const Statement& claim() const { return reading_.claims()[case_.line]; }
    Scope claim_scope() const;
    void each_case(const Statement& statement, std::vector<std::pair<Element, Element>>& found);
    void bind_all(const Statement& statement, Scope& scope);
    Geometric bound_value(const Quantified& quantified, const std::string& name);

    // Variables: second_evaluation_lines.hpp.
    // An abbreviation sees the variables at the place of its use, a map never does.
    std::size_t begin_variables();
    std::size_t add_variable(Key key, Geometric value);
    void assign_variable(std::size_t place, const Element& value);
    void forget_variables(std::size_t first);
    const Geometric* variable(const Key& key) const;

    Element zero() { return field_.number(Rational(0)); }
    Element one() { return field_.number(Rational(1)); }
    Element difference(const Element& a, const Element& b) { return field_.sum(a, field_.negative(b)); }
    [[noreturn]] static void fail(ErrorCode code, const std::string& message, std::size_t offset) {
        throw Error(code, message, {}, offset);
    }

    const Reading& reading_;
    const Case& case_;
    Field& field_;
    Counting counting_;
    std::list<Known> known_;  ///< the last one is in use; rebinding a symbol adds a new one
    std::map<Key, Element> symbols_;
    std::map<std::uint32_t, std::vector<Element>> free_maps_;
    std::map<std::uint32_t, MapShape> shapes_;
    std::vector<Geometric> variables_;  ///< of polynomials and of `for all`; scopes refer to them by position
    std::vector<Key> variable_keys_;    ///< the names of `variables_`
    std::size_t first_visible_ = 0;     ///< the first element of `variables_` that is visible
    Known* map_layer_ = nullptr;        ///< the element of `known_` for maps; the first one if null
    std::map<Key, std::size_t> bound_members_;
    std::vector<std::uint32_t> maps_in_work_;
    std::map<Key, Geometric> points_;
    std::set<Key> abbreviations_in_work_;
    std::vector<std::uint32_t> dimensions_in_work_;
};

}  // namespace blossom::proofs::second
