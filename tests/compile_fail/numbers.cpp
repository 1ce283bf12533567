// MISUSE_INTEGER_FROM_DOUBLE: no matching function|conversion from|no viable conversion
// MISUSE_RATIONAL_FROM_DOUBLE: no matching function|conversion from|no viable conversion
// MISUSE_INTEGER_FROM_TEXT: no matching function|conversion from|no viable conversion
// MISUSE_RATIONAL_FROM_TEXT: no matching function|conversion from|no viable conversion
// MISUSE_INTEGER_FROM_BOOL: no matching function|conversion from|no viable conversion
// MISUSE_RATIONAL_PLUS_DOUBLE: no match for 'operator\+'|invalid operands

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/number_text.hpp>

using namespace blossom;

const Integer three = 3;
const Rational tenth = parse_rational("0.1");
const Rational nearly_tenth = exact_rational(0.1);

#ifdef MISUSE_INTEGER_FROM_DOUBLE
const Integer number = 3.0;
#endif

#ifdef MISUSE_RATIONAL_FROM_DOUBLE
const Rational number = 0.1;
#endif

#ifdef MISUSE_INTEGER_FROM_TEXT
const Integer number = "010";
#endif

#ifdef MISUSE_RATIONAL_FROM_TEXT
const Rational number = "1/0";
#endif

#ifdef MISUSE_INTEGER_FROM_BOOL
const Integer number = true;
#endif

#ifdef MISUSE_RATIONAL_PLUS_DOUBLE
const Rational number = tenth + 0.1;
#endif
