#include "layout.hpp"

#include <algorithm>
#include <utility>

namespace blossom::worked {

namespace {

using Kind = Layout::Kind;

/// How tightly the top of a formula holds together.
enum class Binding { relation, sum, summation, product, power, atom };

class Builder {
public:
    explicit Builder(const Notation& notation) : notation_(notation) {}

    Layout build(const Formula& formula) const {
        const std::vector<Formula>& parts = formula.parts;
        switch (formula.kind) {
            case FormulaKind::number:
                return number_layout(formula.value);
            case FormulaKind::symbol:
                return {Kind::identifier, formula.name, {}};
            case FormulaKind::words:
                return {Kind::words, formula.name, {}};
            case FormulaKind::sum:
                return row(sum_parts(formula));
            case FormulaKind::product:
                return product_layout(formula);
            case FormulaKind::fraction:
                return fraction_layout(formula);
            case FormulaKind::power:
                return {Kind::superscript, "", {bound(parts[0], Binding::atom), build(parts[1])}};
            case FormulaKind::index:
                return {Kind::subscript, "", {bound(parts[0], Binding::atom), build(parts[1])}};
            case FormulaKind::call:
                return applied(name_layout(formula.name), fenced("()", listed(parts)));
            case FormulaKind::application:
                return applied(build(parts[0]), fenced("()", listed({parts.begin() + 1, parts.end()})));
            case FormulaKind::derivative:
                return derivative_layout(formula);
            case FormulaKind::blossom:
                return blossom_layout(formula);
            case FormulaKind::elementary:
                return applied(
                    {Kind::subscript, "", {name_layout(formula.name), number_layout(formula.value)}},
                    fenced("()", listed(parts)));
            case FormulaKind::binomial:
                return {Kind::stack, "", {build(parts[0]), build(parts[1])}};
            case FormulaKind::factorial:
                return row({bound(parts[0], Binding::atom), {Kind::sign, "!", {}}});
            case FormulaKind::tuple:
                return fenced("()", listed(parts));
            case FormulaKind::list:
                return listed(parts, formula.name);
            case FormulaKind::repeated:
                return with_multiplicity(bound(parts[0], Binding::atom), build(parts[1]));
            case FormulaKind::pair:
                return fenced("⟨⟩", listed(parts));
            case FormulaKind::size:
                return fenced("||", build(parts[0]));
            case FormulaKind::cases:
                return {Kind::cases, "", {build(parts[0]), build(parts[1]), build(parts[2])}};
            case FormulaKind::set:
                return fenced("{}", listed(parts));
            case FormulaKind::interval:
                return fenced("[]", listed(parts));
            case FormulaKind::summation:
                return summation_layout(formula);
            case FormulaKind::relation:
                return row(relation_parts(formula));
        }
        return {};
    }

    /// The signs and parts of a sum, alternately; the first sign only if it is a minus.
    std::vector<Layout> sum_parts(const Formula& formula) const {
        std::vector<Layout> layouts;
        for (const Formula& part : formula.parts) {
            const bool negative = is_negative(part);
            if (!layouts.empty() || negative) {
                layouts.push_back({layouts.empty() ? Kind::sign : Kind::binary, negative ? "−" : "+", {}});
            }
            const bool value = part.kind == FormulaKind::blossom;
            layouts.push_back(value ? build(part) : bound(without_sign(part), Binding::summation));
        }
        return layouts;
    }

    Layout relation_sign(const Formula& formula) const { return {Kind::relation, formula.name, {}}; }

    static Layout row(std::vector<Layout> parts) {
        if (parts.size() == 1) return std::move(parts.front());
        return {Kind::row, "", std::move(parts)};
    }

private:
    Binding binding(const Formula& formula) const {
        if (is_negative(formula)) return Binding::sum;
        switch (formula.kind) {
            case FormulaKind::relation:
                return Binding::relation;
            case FormulaKind::sum:
                return Binding::sum;
            case FormulaKind::summation:
            case FormulaKind::cases:
                return Binding::summation;
            case FormulaKind::product:
                // What stands behind the sign of a sum would belong to it.
                return std::min(binding(formula.parts.back()), Binding::product) == Binding::summation
                           ? Binding::summation
                           : Binding::product;
            case FormulaKind::fraction:
                return Binding::product;
            case FormulaKind::number:
                return formula.value.is_integer() ? Binding::atom : Binding::product;
            case FormulaKind::power:
            case FormulaKind::factorial:
                return Binding::power;
            case FormulaKind::blossom:
                // A product of arguments needs parentheses beside other factors.
                return notation_.style == BlossomStyle::multiplicative && formula.parts.size() > 1
                           ? Binding::sum
                           : Binding::atom;
            default:
                return Binding::atom;
        }
    }

    /// In parentheses unless it binds at least as tightly as `wanted`.
    Layout bound(const Formula& formula, Binding wanted) const {
        return binding(formula) < wanted ? fenced("()", build(formula)) : build(formula);
    }

    static Layout fenced(std::string fences, Layout inside) {
        return {Kind::fenced, std::move(fences), {std::move(inside)}};
    }

    static Layout applied(Layout name, Layout arguments) {
        return row({std::move(name), {Kind::apply, "", {}}, std::move(arguments)});
    }

    static Layout number_layout(const Rational& value) {
        const Rational size = abs(value);
        Layout layout{Kind::number, to_string(size), {}};
        if (!size.is_integer()) {
            layout = {Kind::fraction,
                      "",
                      {{Kind::number, to_string(size.numerator()), {}},
                       {Kind::number, to_string(size.denominator()), {}}}};
        }
        if (value.sign() >= 0) return layout;
        return row({{Kind::sign, "−", {}}, std::move(layout)});
    }

    Layout name_layout(const std::string& name) const { return build(symbol(name)); }

    Layout listed(const std::vector<Formula>& parts, const std::string& separator = ",") const {
        std::vector<Layout> layouts;
        for (const Formula& part : parts) {
            if (!layouts.empty()) layouts.push_back({Kind::comma, separator, {}});
            layouts.push_back(build(part));
        }
        return row(std::move(layouts));
    }

    /// Whether a factor begins with a digit, so that it needs a sign before it.
    static bool begins_with_digit(const Formula& formula) {
        switch (formula.kind) {
            case FormulaKind::number:
                return true;
            case FormulaKind::product:
            case FormulaKind::power:
            case FormulaKind::factorial:
            case FormulaKind::fraction:
                return begins_with_digit(formula.parts.front());
            default:
                return false;
        }
    }

    Layout product_layout(const Formula& formula) const {
        if (is_negative(formula)) {
            return row({{Kind::sign, "−", {}}, bound(without_sign(formula), Binding::summation)});
        }
        std::vector<Layout> layouts;
        for (const Formula& factor : formula.parts) {
            const Binding wanted = &factor == &formula.parts.back() ? Binding::summation : Binding::product;
            const bool fences = binding(factor) < wanted;
            if (!layouts.empty()) {
                const bool dot = !fences && (begins_with_digit(factor) || factor.kind == FormulaKind::tuple);
                layouts.push_back(dot ? Layout{Kind::binary, "·", {}} : Layout{Kind::times, "", {}});
            }
            layouts.push_back(bound(factor, wanted));
        }
        return row(std::move(layouts));
    }

    Layout fraction_layout(const Formula& formula) const {
        if (is_negative(formula)) return row({{Kind::sign, "−", {}}, build(without_sign(formula))});
        return {Kind::fraction, "", {build(formula.parts[0]), build(formula.parts[1])}};
    }

    Layout derivative_layout(const Formula& formula) const {
        const std::string order = to_string(formula.value);
        Layout head = name_layout(formula.name);
        if (order == "1" || order == "2" || order == "3") {
            head = row({std::move(head),
                        {Kind::sign,
                         std::string(order == "1"   ? "′"
                                     : order == "2" ? "″"
                                                    : "‴"),
                         {}}});
        } else if (order != "0") {
            head = {Kind::superscript, "", {std::move(head), fenced("()", {Kind::number, order, {}})}};
        }
        return applied(std::move(head), fenced("()", listed(formula.parts)));
    }

    Layout summation_layout(const Formula& formula) const {
        const std::vector<Formula>& parts = formula.parts;
        Layout sign{
            Kind::under, "", {{Kind::sign, formula.name.empty() ? "∑" : formula.name, {}}, build(parts[0])}};
        if (parts.size() == 3) sign.parts.push_back(build(parts[2]));
        return row({std::move(sign), bound(parts[1], Binding::summation)});
    }

    /// One argument, with its multiplicity.
    static Layout with_multiplicity(Layout argument, Layout times) {
        return {Kind::superscript, "", {std::move(argument), fenced("⟨⟩", std::move(times))}};
    }

    /// With brackets around each argument, or only around those that need them beside a multiplicity.
    std::vector<Layout> argument_layouts(const std::vector<Formula>& arguments, bool bracketed) const {
        std::vector<Layout> layouts;
        for (auto begin = arguments.begin(); begin != arguments.end();) {
            auto end = begin + 1;
            while (notation_.multiplicities && end != arguments.end() && *end == *begin) ++end;
            Layout argument = bracketed ? fenced("()", build(*begin))
                                        : bound(*begin, end - begin > 1 ? Binding::atom : Binding::relation);
            layouts.push_back(end - begin == 1
                                  ? std::move(argument)
                                  : with_multiplicity(std::move(argument),
                                                      {Kind::number, std::to_string(end - begin), {}}));
            begin = end;
        }
        return layouts;
    }

    /// Arguments that are no letters are bracketed in the multiplicative notation, in which 2 3 would be 6.
    Layout blossom_layout(const Formula& formula) const {
        const bool multiplicative = notation_.style == BlossomStyle::multiplicative && !formula.parts.empty();
        const bool letters = std::ranges::all_of(formula.parts, [](const Formula& argument) {
            return argument.kind == FormulaKind::symbol || argument.kind == FormulaKind::index;
        });
        std::vector<Layout> inside;
        for (Layout& argument : argument_layouts(formula.parts, multiplicative && !letters)) {
            if (!inside.empty())
                inside.push_back(multiplicative ? Layout{Kind::times, "", {}} : Layout{Kind::comma, ",", {}});
            inside.push_back(std::move(argument));
        }
        if (multiplicative) return row(std::move(inside));
        return applied(
            name_layout(formula.name),
            fenced(notation_.style == BlossomStyle::brackets ? "[]" : "()", row(std::move(inside))));
    }

    std::vector<Layout> relation_parts(const Formula& formula) const {
        std::vector<Layout> layouts;
        for (const Formula& side : formula.parts) {
            if (!layouts.empty()) layouts.push_back(relation_sign(formula));
            layouts.push_back(build(side));
        }
        return layouts;
    }

    const Notation& notation_;
};

}  // namespace

Layout layout_of(const Formula& formula, const Notation& notation) {
    return Builder(notation).build(formula);
}

std::vector<Piece> pieces_of(const Formula& formula, const Notation& notation) {
    const Builder builder(notation);
    const bool chain = formula.kind == FormulaKind::relation;
    const std::vector<Formula> sides = chain ? formula.parts : std::vector<Formula>{formula};
    std::vector<Piece> pieces;
    for (const Formula& side : sides) {
        std::vector<Layout> layouts =
            side.kind == FormulaKind::sum ? builder.sum_parts(side) : std::vector{builder.build(side)};
        std::vector<Layout> current;
        bool begins_side = !pieces.empty();
        if (begins_side) current.push_back(builder.relation_sign(formula));
        for (Layout& layout : layouts) {
            if (layout.kind == Kind::binary) {
                pieces.push_back({Builder::row(std::move(current)), begins_side});
                current.clear();
                begins_side = false;
            }
            current.push_back(std::move(layout));
        }
        pieces.push_back({Builder::row(std::move(current)), begins_side});
    }
    return pieces;
}

}  // namespace blossom::worked
