// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Check.h
 * @brief Claims of a kernel test: counted, the failing ones printed, the verdict returned from
 * main.
 */
#ifndef sb_Check_h
#define sb_Check_h

#include <iostream>

namespace check
{

struct Count
{
  long Claims = 0;
  long Failures = 0;
};

inline Count& Total()
{
  static Count count;
  return count;
}

/** Whether to print this failure: a test that is wrong throughout would print a million. */
inline bool Fail(const char* file, int line, const char* claim)
{
  const long printed = 20;
  if (++Total().Failures > printed)
  {
    return false;
  }
  std::cerr << file << ":" << line << ": not true: " << claim << "\n";
  return true;
}

inline void Claim(bool holds, const char* file, int line, const char* claim)
{
  ++Total().Claims;
  if (!holds)
  {
    Fail(file, line, claim);
  }
}

template <class A, class B>
void Equal(const A& found, const B& expected, const char* file, int line, const char* claim)
{
  ++Total().Claims;
  if (!(found == expected) && Fail(file, line, claim))
  {
    std::cerr << "  found " << found << ", expected " << expected << "\n";
  }
}

/** What main returns. A test that claims nothing fails. */
inline int Verdict(const char* test)
{
  std::cout << test << ": " << Total().Claims << " claims, " << Total().Failures << " failures\n";
  return Total().Failures == 0 && Total().Claims > 0 ? 0 : 1;
}

} // namespace check

#define CHECK(condition) check::Claim(static_cast<bool>(condition), __FILE__, __LINE__, #condition)
#define CHECK_EQUAL(found, expected)                                                               \
  check::Equal((found), (expected), __FILE__, __LINE__, #found " == " #expected)

#endif
