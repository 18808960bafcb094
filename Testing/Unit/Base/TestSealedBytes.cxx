// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/SealedBytes.h"

#include <gtest/gtest.h>

namespace
{
std::string Refusal(std::string_view bytes)
{
  try
  {
    ruc::UnsealBytes(bytes, "RUCTESTS", 2, "a test");
    return "<no exception>";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}
}

// The published values of FNV-1a-64 for these texts
TEST(SealedBytes, Fingerprints)
{
  EXPECT_EQ(ruc::FingerprintOfBytes(""), 0xcbf29ce484222325u);
  EXPECT_EQ(ruc::FingerprintOfBytes("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(ruc::FingerprintOfBytes("foobar"), 0x85944171f73967e8u);
}

TEST(SealedBytes, ComeBackOrAreRefused)
{
  for (const std::string& body : { std::string(), std::string("body\0with null", 14) })
  {
    const std::string sealed = ruc::SealBytes("RUCTESTS", 2, body);
    EXPECT_EQ(sealed.size(), body.size() + 28);
    EXPECT_EQ(ruc::UnsealBytes(sealed, "RUCTESTS", 2, "a test"), body);
    for (std::size_t n = 0; n < sealed.size(); ++n)
    {
      EXPECT_NE(Refusal(std::string_view(sealed).substr(0, n)), "<no exception>") << n;
      std::string damaged = sealed;
      damaged[n] = static_cast<char>(damaged[n] ^ 1);
      EXPECT_NE(Refusal(damaged), "<no exception>") << n;
    }
  }
  EXPECT_EQ(Refusal("RUCOTHER"), "These bytes are no checkpoint of a test.");
  EXPECT_EQ(Refusal(ruc::SealBytes("RUCTESTS", 1, "")),
    "The checkpoint is of version 1, this program reads version 2.");
}
