// One blossom value: prepared, unprepared, and in batches.

#include <blossom/core/blossom/blossom.hpp>

#include <memory>

#include "boost_numbers.hpp"
#include "cases.hpp"
#include "families.hpp"
#include "flint_values.hpp"

namespace {

using namespace blossom;

template <class Number>
Side textbook_side(const char* name, const Case& given) {
    auto coefficients = boost_numbers<Number>(given.coefficients);
    auto arguments = boost_numbers<Number>(given.arguments);
    auto value = std::make_shared<Number>();
    return {name, [=] { *value = textbook::symmetric(coefficients, arguments); },
            [=] { return value->str(); }};
}

/// The rows of one degree and size of numbers, for which the map is prepared once.
class ValueRows {
public:
    ValueRows(std::size_t degree, std::size_t bits)
        : given_(make_case(degree, bits)),
          curve_(curve_of(given_)),
          map_(curve_),
          arguments_(arguments_of(given_)),
          blossom_(curve_),
          flint_(curve_.coefficients().numbers()),
          flint_arguments_(given_.arguments) {
        flint_.prepare();
    }

    void prepared(const Report& report) {
        std::vector<Side> sides{
            engine([this] { value_ = blossom_.coordinate(0, arguments_); }),
            flint("FLINT", [this] { flint_.value(flint_arguments_); }),
        };
        if (textbook_is_bearable(given_)) {
            sides.push_back(textbook_side<mpq_rational>("mpq_rational", given_));
            if (given_.degree <= 20) sides.push_back(textbook_side<cpp_rational>("cpp_rational", given_));
        }
        compare(report, "prepared", sides);
    }

    void once(const Report& report) {
        std::vector<Side> sides{
            engine([this] { value_ = blossom_value(map_, arguments_, Construction::symmetric)[0]; }),
            flint("FLINT",
                  [this] {
                      flint_.prepare();
                      flint_.value(flint_arguments_);
                  }),
        };
        // Beyond this degree, the denominators from the binomials are too large to compete.
        if (given_.degree <= 100) {
            sides.push_back(
                flint("FLINT splitting", [this] { flint_.value_by_splitting(flint_arguments_); }));
        }
        if (textbook_is_bearable(given_))
            sides.push_back(textbook_side<mpq_rational>("mpq_rational", given_));
        compare(report, "one-shot", sides);
    }

    /// Both sides allocate the memory of all results before the timed part.
    void batch_of_8(const Report& report) {
        const std::vector<std::vector<Argument>> tuples(8, arguments_);
        std::vector<Rational> values(tuples.size());
        const Side all{"engine", [&] { blossom_.values(tuples, values); },
                       [&] { return to_string(values.back()); }};
        compare(report, "batch of 8", {all, flint("FLINT", [this] {
                                           for (int i = 0; i < 8; ++i) flint_.value(flint_arguments_);
                                       })});
    }

private:
    Side engine(std::function<void()> run) {
        return {"engine", std::move(run), [this] { return to_string(value_); }};
    }
    Side flint(const char* name, std::function<void()> run) {
        return {name, std::move(run), [this] { return flint_.text(); }};
    }
    void compare(const Report& report, const char* work, const std::vector<Side>& sides) {
        report.compare("values", work, given_.degree, given_.bits, sides);
    }

    Case given_;
    PolynomialCurve curve_;
    PolynomialMap map_;  ///< the curve in the form that `blossom_value` takes, so that it is not copied
    std::vector<Argument> arguments_;
    Blossom blossom_;
    flint_peer::Polynomial flint_;
    flint_peer::Arguments flint_arguments_;
    Rational value_;
};

}  // namespace

void measure_values(const Report& report) {
    for (const std::size_t bits : {4U, 7U, 64U, 256U}) {
        for (const std::size_t degree : {3U, 10U, 20U, 40U, 100U, 300U, 1000U, 3000U}) {
            if (degree * bits > (report.quick() ? 7'000U : 64'000U)) continue;
            const bool prepared = report.wants("prepared", degree, bits);
            const bool once = report.wants("one-shot", degree, bits);
            const bool batch = degree <= 20 && report.wants("batch of 8", degree, bits);
            if (!prepared && !once && !batch) continue;
            ValueRows rows(degree, bits);
            if (prepared) rows.prepared(report);
            if (once) rows.once(report);
            if (batch) rows.batch_of_8(report);
        }
    }
}
