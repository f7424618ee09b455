// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_NumberOption_h
#define Testing_Benchmarks_NumberOption_h

#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

/** The value of an option of a benchmark. Throws std::runtime_error where the text is no number, is
 * outside of the range, ends included, or not a whole one although the type takes no others. */
template <typename Number>
Number ReadNumberOption(
  const std::string& option, const std::string& text, Number smallest, Number largest)
{
  std::istringstream stream(text);
  double number = 0.0; // So that 1e6 is a whole number, too.
  const bool isInRange = stream >> number && stream.eof() &&
    number >= static_cast<double>(smallest) && number <= static_cast<double>(largest);
  if (!isInRange || static_cast<double>(static_cast<Number>(number)) != number)
  {
    std::ostringstream message;
    message << option << " takes " << (std::is_integral_v<Number> ? "whole " : "")
            << "numbers from " << smallest << " to " << largest << ", not '" << text << "'";
    throw std::runtime_error(message.str());
  }
  return static_cast<Number>(number);
}

#endif
