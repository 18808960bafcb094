// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FoundWindow.h"

#include "EnclosedPacks.h"
#include "Oracles.h"
#include "ThreadRanks.h"

namespace
{
using ruc::FoundWindow;
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;
using ruc::WindowChoices;

// How far a fraction in a window that was found may lie from that deep inside
constexpr double MostError = 0.003;

const SpherePack& Settled()
{
  static const SpherePack pack = oracle::ReadTable(RUC_TEST_DATA "/settled_cylinder.csv");
  return pack;
}

FoundWindow Find(const SpherePack& pack, const WindowChoices& choices = {},
  const std::optional<Window>& box = std::nullopt)
{
  ruc::Communicator alone;
  return ruc::FindWindow(pack, box, choices, alone);
}

bool Says(const FoundWindow& found, const std::string& text)
{
  return std::any_of(found.Warnings.begin(), found.Warnings.end(),
    [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

// A lognormal pack between walls along z, periodic along x and y
const Window& Slit()
{
  static const Window box =
    oracle::CubeFor(oracle::LognormalRadii(4000, 0.2, 1), 0.58, { true, true, false });
  return box;
}
const SpherePack& InSlit()
{
  static const SpherePack pack =
    oracle::PackBetweenWalls(oracle::LognormalRadii(4000, 0.2, 1), Slit(), 2, 150);
  return pack;
}
}

TEST(FoundWindow, ACylinderIsKeptAwayFrom)
{
  const FoundWindow found = Find(Settled());
  ASSERT_TRUE(found.Observed);
  EXPECT_EQ(found.Source, "Eroded");
  EXPECT_EQ(found.Faces, "mantle=z; z-=wall; z+=loose");
  const double away = 56.0 * found.Erosion;
  EXPECT_NEAR(found.Observed->Radius, 1026.0 - away, 3.0);
  EXPECT_NEAR(found.Observed->Base[2], away, 5.0); // the floor is soft
  // By points in the largest box that stays 250 away from the mantle, 200 from floor and surface
  const double deep = oracle::FractionByPoints(
    Settled(), Window::MakeBox({ -548, -548, 200 }, { 1096, 1096, 500 }, {}));
  EXPECT_NEAR(oracle::FractionIn(Settled(), *found.Observed), deep, MostError);
  EXPECT_EQ(found.Outside,
    static_cast<std::int64_t>(Settled().Size() - CropToWindow(Settled(), *found.Observed).Size()));
  EXPECT_TRUE(Says(found, "a cylinder along z of radius 102"));
  EXPECT_TRUE(Says(found, "face z- looks like a wall ("));
  EXPECT_TRUE(Says(found, "face z+ looks loose: window kept 1.6"));
}

TEST(FoundWindow, BlocksThatWereTakenInThreeWays)
{
  const Vector3 low = { -350, -340, 110 }, high = { 330, 360, 780 };
  const double truth =
    oracle::FractionByPoints(Settled(), Window::MakeBox(low, { 680, 700, 670 }, {}));
  const FoundWindow cut = Find(TakeBlock(Settled(), low, high, oracle::Taken::ByCentre));
  ASSERT_TRUE(cut.Observed);
  EXPECT_EQ(cut.Source, "Cut faces");
  EXPECT_EQ(cut.Erosion, 0.0);
  EXPECT_EQ(cut.Faces, "x-=cut; x+=cut; y-=cut; y+=cut; z-=cut; z+=cut");
  EXPECT_TRUE(cut.Warnings.empty());
  EXPECT_NEAR(oracle::FractionIn(Settled(), *cut.Observed), truth, MostError);
  for (oracle::Taken taken : { oracle::Taken::Whole, oracle::Taken::Touching })
  {
    const FoundWindow loose = Find(TakeBlock(Settled(), low, high, taken));
    ASSERT_TRUE(loose.Observed);
    EXPECT_EQ(loose.Source, "Eroded");
    EXPECT_TRUE(Says(loose, "faces x-, x+, y-, y+, z-, z+ look loose"));
    // The window holds some 1500 spheres of many sizes, whose fraction scatters by 0.005
    EXPECT_NEAR(oracle::FractionIn(Settled(), *loose.Observed), truth, 0.015);
  }
}

TEST(FoundWindow, CutFacesAreTheBoundsOfTheCentres)
{
  const SpherePack block =
    TakeBlock(Settled(), { -350, -340, 110 }, { 330, 360, 780 }, oracle::Taken::ByCentre);
  const Window window = *Find(block).Observed;
  const std::vector<double>* axes[3] = { &block.X, &block.Y, &block.Z };
  for (int q = 0; q < 3; ++q)
  {
    const auto [least, greatest] = std::minmax_element(axes[q]->begin(), axes[q]->end());
    EXPECT_EQ(window.Origin[q], *least);
    EXPECT_GE(window.Origin[q] + window.Size[q], *greatest);
    EXPECT_DOUBLE_EQ(window.Size[q], *greatest - *least);
  }
  EXPECT_EQ(CropToWindow(block, window).Size(), block.Size());
}

TEST(FoundWindow, APeriodicBoxIsTheWindow)
{
  const Window box = Window::MakeBox({ -1, -2, -3 }, { 5, 6, 7 }, { true, true, true });
  SpherePack pack;
  pack.Append({ { 0 }, { 0 }, { 0 }, { 1 }, {}, {} }, 0);
  const FoundWindow found = Find(pack, {}, box);
  EXPECT_EQ(*found.Observed, box);
  EXPECT_EQ(found.Source, "File");
  EXPECT_TRUE(found.Faces.empty());
}

TEST(FoundWindow, PeriodicAxesAreKept)
{
  Window tall = Slit();
  tall.Size[2] *= 3.0;
  const FoundWindow found = Find(InSlit(), {}, tall);
  ASSERT_TRUE(found.Observed);
  EXPECT_EQ(found.Faces, "x-=periodic; x+=periodic; y-=periodic; y+=periodic; z-=wall; z+=wall");
  EXPECT_EQ(found.Observed->Periodic, (std::array<bool, 3>{ true, true, false }));
  for (int q : { 0, 1 })
  {
    EXPECT_EQ(found.Observed->Origin[q], tall.Origin[q]);
    EXPECT_EQ(found.Observed->Size[q], tall.Size[q]);
  }
  EXPECT_TRUE(Says(found, "the box of the file is 3 times the pack along z: not the window."));
}

TEST(FoundWindow, WhatIsChosenIsTaken)
{
  WindowChoices choices;
  choices.Erosion = 1.25;
  const double diameter = 2.0 * InSlit().LargestRadius();
  FoundWindow found = Find(InSlit(), choices, Slit());
  EXPECT_EQ(found.Erosion, 1.25);
  EXPECT_NEAR(found.Observed->Origin[2], 1.25 * diameter, 1e-9 * diameter);
  EXPECT_NEAR(found.Observed->Size[2], Slit().Size[2] - 2.5 * diameter, 1e-9 * diameter);

  choices.Faces = "z-=cut";
  found = Find(InSlit(), choices, Slit());
  EXPECT_EQ(found.Faces, "x-=periodic; x+=periodic; y-=periodic; y+=periodic; z-=cut; z+=wall");
  EXPECT_EQ(found.Observed->Origin[2], *std::min_element(InSlit().Z.begin(), InSlit().Z.end()));

  choices.Faces = "all=cut";
  found = Find(InSlit(), choices, Slit());
  EXPECT_EQ(found.Source, "Cut faces");
  EXPECT_EQ(found.Erosion, 0.0);

  choices.Erosion = -1.0;
  choices.Faces = "mantle=none, z-=cut z+=cut";
  found = Find(Settled(), choices);
  EXPECT_EQ(found.Faces.rfind("x-=", 0), 0u);
  choices.Faces = "mantle=x";
  EXPECT_EQ(Find(Settled(), choices).Faces.rfind("mantle=x; x-=", 0), 0u);
  choices.Faces = "z-=cut; all=loose"; // whatever the order, a face's own word counts
  EXPECT_EQ(Find(Settled(), choices).Faces, "mantle=z; z-=cut; z+=loose");
  choices.Faces = "x-=cut"; // a face that a cylinder along z does not have
  EXPECT_EQ(Find(Settled(), choices).Faces.rfind("x-=cut; x+=", 0), 0u);
}

TEST(FoundWindow, WhatIsChosenIsNotToldAsFound)
{
  ASSERT_TRUE(Says(Find(InSlit(), {}, Slit()), "like a wall"));
  WindowChoices choices;
  choices.Faces = "z-=wall; z+=wall";
  EXPECT_FALSE(Says(Find(InSlit(), choices, Slit()), "like a wall"));
  ASSERT_TRUE(Says(Find(Settled()), "a cylinder along z"));
  choices.Faces = "mantle=z";
  EXPECT_FALSE(Says(Find(Settled(), choices), "a cylinder along z"));
}

TEST(FoundWindow, ChoicesOfAnotherForm)
{
  const auto message = [](const std::string& faces)
  {
    return oracle::MessageOf(
      [&]()
      {
        WindowChoices choices;
        choices.Faces = faces;
        Find(InSlit(), choices, Slit());
      });
  };
  for (const char* faces : { "z", "z-=", "w-=cut", "z-=open", "z-=periodic", "mantle=q",
         "mantle=", "mantle=xy", "=", "z-=wall z-=wall", "mantle=z mantle=none" })
  {
    EXPECT_NE(message(faces).find("FaceKinds requires faces, each once, and what they are"),
      std::string::npos)
      << faces;
    const std::string last = faces;
    EXPECT_NE(message(faces).find("got " + last.substr(last.rfind(' ') + 1)), std::string::npos)
      << faces;
  }
  EXPECT_NE(message("mantle=y; z+=cut").find("only the faces that close it, got mantle=y"),
    std::string::npos);
  EXPECT_NE(message("x-=wall").find("axes that are not periodic, got x-"), std::string::npos);
  EXPECT_NE(message("mantle=z").find("across which the pack is not periodic"), std::string::npos);
}

TEST(FoundWindow, AnErosionThatLeavesTooLittle)
{
  WindowChoices choices;
  choices.Erosion = 5.0;
  const std::string message = oracle::MessageOf([&]() { Find(InSlit(), choices, Slit()); });
  EXPECT_NE(message.find("WindowErosion requires that it leaves 500 spheres and an edge of 4"),
    std::string::npos)
    << message;
  // An automatic one leaves the window open instead
  const SpherePack few =
    TakeBlock(Settled(), { -170, -170, -1 }, { 170, 170, 340 }, oracle::Taken::ByCentre);
  ASSERT_GE(few.Size(), 500u);
  const FoundWindow found = Find(few);
  EXPECT_FALSE(found.Observed);
  EXPECT_TRUE(Says(found, "no window is taken: 500 spheres and an edge of 4"));
}

TEST(FoundWindow, FewSpheresTellNothingUnlessTheyAreAsked)
{
  const SpherePack few =
    TakeBlock(Settled(), { -80, -80, 200 }, { 80, 80, 360 }, oracle::Taken::ByCentre);
  ASSERT_LT(few.Size(), 500u);
  EXPECT_FALSE(Find(few).Observed);
  EXPECT_TRUE(Find(few).Warnings.empty());
  const Window open = Window::MakeBox({ -80, -80, 0 }, { 160, 160, 900 }, { true, true, false });
  const FoundWindow slit = Find(few, {}, open);
  ASSERT_TRUE(slit.Observed);
  EXPECT_TRUE(Says(slit, "faces z-, z+ taken as cut; the spheres are too few to tell."));
  WindowChoices choices;
  choices.Faces = "all=cut";
  EXPECT_TRUE(Find(few, choices).Observed);
}

TEST(FoundWindow, AnOddContainerHasNone)
{
  SpherePack ball;
  for (std::size_t i = 0; i < Settled().Size(); ++i)
  {
    const Vector3 c = Settled().Centre(i);
    if (ruc::Length({ c[0], c[1], c[2] - 440.0 }) < 400.0)
    {
      ball.Append(Settled(), i);
    }
  }
  const FoundWindow found = Find(ball);
  EXPECT_FALSE(found.Observed) << found.Faces << found.Observed->Describe();
  EXPECT_TRUE(Says(found, "neither a box nor a cylinder along an axis"));
}

TEST(FoundWindow, NumbersThatAreNoneTellNothing)
{
  SpherePack pack = InSlit();
  pack.Z[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Find(pack).Observed);
  EXPECT_FALSE(Find(SpherePack()).Observed);
}

TEST(FoundWindow, SameOnAnyNumberOfRanks)
{
  const FoundWindow alone = Find(InSlit(), {}, Slit());
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& ranks)
    {
      SpherePack piece; // rank 1 has none
      for (std::size_t i = 0; i < InSlit().Size(); ++i)
      {
        if (ranks.Rank() == (i % 3 == 0 ? 0 : 2))
        {
          piece.Append(InSlit(), i);
        }
      }
      const FoundWindow found = ruc::FindWindow(piece, Slit(), {}, ranks);
      EXPECT_EQ(*found.Observed, *alone.Observed);
      EXPECT_EQ(found.Faces, alone.Faces);
      EXPECT_EQ(found.Erosion, alone.Erosion);
      EXPECT_EQ(found.Warnings, alone.Warnings);
    });
}
