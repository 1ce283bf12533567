// Which types convert to the numeric types of the library: integers of any width, and nothing else, neither
// by accident nor in an operation with another value.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/integer.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace blossom;

enum Unscoped : int {};
enum class Scoped : int {};

template <class... Types>
struct TypeList {};
// The columns of the table.
using Columns = TypeList<int, std::int64_t, std::uint64_t, std::size_t, signed char, unsigned short,
                         WideInteger, WideUnsigned, bool, char, wchar_t, char8_t, char32_t, float, double,
                         long double, const char*, std::string, std::string_view, Unscoped, Scoped>;
constexpr std::string_view integers_only = "++++++++-------------";
constexpr std::string_view nothing = "---------------------";

// The row of a table: '+' for each type with which `Allowed::of<Type>` is true.
template <class Allowed, class... Types>
std::string row_of(TypeList<Types...>) {
    return {(Allowed::template of<Types> ? '+' : '-')...};
}

// Whether an implicit conversion exists, and whether an explicit one does.
template <class Target>
struct Converts {
    template <class Type>
    static constexpr bool of = std::is_convertible_v<Type, Target>;
};
template <class Target, class... Front>
struct Constructs {
    template <class Type>
    static constexpr bool of = std::is_constructible_v<Target, Front..., Type>;
};

#define OPERATION(name, expression)                                                   \
    template <class Value>                                                            \
    struct name {                                                                     \
        template <class Type>                                                         \
        static constexpr bool of = requires(Value value, Type other) { expression; }; \
    }
OPERATION(Sum, value + other);
OPERATION(SumBehind, other + value);
OPERATION(Difference, value - other);
OPERATION(Product, value* other);
OPERATION(ProductBehind, other* value);
OPERATION(Quotient, value / other);
OPERATION(Remainder, value % other);
OPERATION(AddTo, value += other);
OPERATION(MultiplyBy, value *= other);
OPERATION(Equals, value == other);
OPERATION(Less, value < other);
OPERATION(Assign, value = other);
OPERATION(ShiftLeft, value << other);
OPERATION(ShiftRight, value >> other);
OPERATION(ShiftBy, value <<= other);
OPERATION(Power, pow(value, other));

template <class Allowed>
std::string row() {
    return row_of<Allowed>(Columns{});
}

template <class Value>
void require_ring_operations() {
    CHECK(row<Sum<Value>>() == integers_only);
    CHECK(row<SumBehind<Value>>() == integers_only);
    CHECK(row<Difference<Value>>() == integers_only);
    CHECK(row<Product<Value>>() == integers_only);
    CHECK(row<ProductBehind<Value>>() == integers_only);
    CHECK(row<AddTo<Value>>() == integers_only);
    CHECK(row<MultiplyBy<Value>>() == integers_only);
    CHECK(row<Equals<Value>>() == integers_only);
    CHECK(row<Assign<Value>>() == integers_only);
    CHECK(row<Power<Value>>() == integers_only);
}

}  // namespace

TEST_CASE("numeric types are made from integers of any width and from nothing else") {
    CHECK(row<Converts<Integer>>() == integers_only);
    CHECK(row<Converts<Rational>>() == integers_only);
    CHECK(row<Converts<Polynomial>>() == integers_only);
    CHECK(row<Converts<SparsePolynomial>>() == integers_only);
    CHECK(row<Converts<Parameter>>() == integers_only);
    CHECK(row<Converts<Argument>>() == integers_only);
    CHECK(row<Converts<Count>>() == integers_only);
    CHECK(row<Converts<Direction>>() == nothing);
    CHECK(row<Constructs<Integer>>() == integers_only);
    CHECK(row<Constructs<Rational>>() == integers_only);
    CHECK(row<Constructs<Polynomial>>() == integers_only);
    CHECK(row<Constructs<SparsePolynomial>>() == integers_only);
    CHECK(row<Constructs<Parameter>>() == integers_only);
    CHECK(row<Constructs<Argument>>() == integers_only);
    CHECK(row<Constructs<Count>>() == integers_only);
    CHECK(row<Constructs<Rational, int>>() == integers_only);
    CHECK(row<Constructs<Argument, int>>() == integers_only);
    CHECK(row<Constructs<Interval, int>>() == integers_only);
    CHECK(row<Constructs<PolynomialCurve, Polynomial>>() == integers_only);
    CHECK(row<Constructs<KnotVector, int, std::vector<Rational>>>() == integers_only);
}

TEST_CASE("operations of numeric types take integers of any width and nothing else") {
    require_ring_operations<Integer>();
    require_ring_operations<Rational>();
    require_ring_operations<Polynomial>();
    require_ring_operations<SparsePolynomial>();
    CHECK(row<Quotient<Integer>>() == integers_only);
    CHECK(row<Quotient<Rational>>() == integers_only);
    CHECK(row<Remainder<Integer>>() == integers_only);
    CHECK(row<Less<Integer>>() == integers_only);
    CHECK(row<Less<Rational>>() == integers_only);
    CHECK(row<ShiftLeft<Integer>>() == integers_only);
    CHECK(row<ShiftRight<Integer>>() == integers_only);
    CHECK(row<ShiftBy<Integer>>() == integers_only);
    CHECK(row<Product<Direction>>() == integers_only);
    CHECK(row<ProductBehind<Direction>>() == integers_only);
    CHECK(row<Sum<Direction>>() == nothing);
    CHECK(row<Sum<Parameter>>() == nothing);
    CHECK(row<Product<Parameter>>() == nothing);
}

TEST_CASE("integers of any width are exact") {
    CHECK(to_string(Polynomial(std::size_t{5'000'000'000})) == "5000000000");
    CHECK(to_string(Integer(std::numeric_limits<std::uint64_t>::max())) == "18446744073709551615");
    CHECK(to_string(Integer(~WideUnsigned{0})) == "340282366920938463463374607431768211455");
    const WideInteger least = -(WideInteger{1} << 126) - (WideInteger{1} << 126);
    CHECK(to_string(Integer(least)) == "-170141183460469231731687303715884105728");
    CHECK(to_string(Rational(WideInteger{-3})) == "-3");
}
