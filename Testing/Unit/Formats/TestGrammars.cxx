// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The corners of every grammar of texts
#include "FormatFiles.h"

namespace
{
using formats::OpenText;
using ruc::PackFrame;
using ruc::Vector3;
using Doubles = std::vector<double>;

PackFrame Parse(std::string_view text)
{
  return OpenText(text).Frame();
}

// A dump of two atoms with that box and those columns
std::string Dump(const std::string& box, const std::string& columns, const std::string& rows)
{
  return "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + box + "\nITEM: ATOMS " +
    columns + "\n" + rows;
}

const std::string Cube = "pp ff pp\n0 10\n-5 5\n0 20";
}

TEST(DumpGrammar, KindsOfPositions)
{
  const std::pair<const char*, const char*> columns[] = {
    { "id x y z", "1 2.5 1 5\n2 5 -1 10\n" }, { "id xu yu zu", "1 2.5 1 5\n2 5 -1 10\n" },
    { "id xs ys zs", "1 0.25 0.6 0.25\n2 0.5 0.4 0.5\n" },
    { "zsu ysu xsu id", "0.25 0.6 0.25 1\n0.5 0.4 0.5 2\n" },
    { "xs ys zs x y z", "0 0 0 2.5 1 5\n0 0 0 5 -1 10\n" }, // x y z goes first
  };
  for (const auto& [names, rows] : columns)
  {
    SCOPED_TRACE(names);
    const PackFrame frame = Parse(Dump(Cube, names, rows));
    EXPECT_EQ(frame.X, (Doubles{ 2.5, 5 }));
    EXPECT_EQ(frame.Y, (Doubles{ 1, -1 }));
    EXPECT_EQ(frame.Z, (Doubles{ 5, 10 }));
    EXPECT_EQ(frame.Box->Periodic, (std::array<bool, 3>{ true, false, true }));
    EXPECT_TRUE(frame.Box->PeriodicityKnown);
    EXPECT_EQ(frame.Step, 5);
  }
  EXPECT_SAYS(Parse(Dump(Cube, "id x yu zs", "1 1 1 1\n2 2 2 2\n")),
    "three positions of one kind are required");
}

TEST(DumpGrammar, Radii)
{
  EXPECT_EQ(Parse(Dump(Cube, "x y z radius", "1 1 1 2\n2 2 2 3\n")).Radius, (Doubles{ 2, 3 }));
  EXPECT_EQ(Parse(Dump(Cube, "x y z diameter", "1 1 1 2\n2 2 2 3\n")).Radius, (Doubles{ 1, 1.5 }));
  EXPECT_EQ(Parse(Dump(Cube, "x y z diameter radius", "1 1 1 4 2\n2 2 2 6.001 3\n")).Radius,
    (Doubles{ 2, 3 }));
  EXPECT_SAYS(Parse(Dump(Cube, "x y z diameter radius", "1 1 1 4 4\n2 2 2 6 3\n")),
    "Line 10: radius and diameter are required to agree, got 4 and 4.");
  EXPECT_TRUE(Parse(Dump(Cube, "x y z", "1 1 1\n2 2 2\n")).Radius.empty());
}

TEST(DumpGrammar, SectionsInAnyOrder)
{
  const PackFrame frame =
    Parse("ITEM: UNITS\nmicro\nITEM: TIME\n0.25\nITEM: TIMESTEP\n7\nITEM: LABEL\nwhat ever\nITEM: "
          "SOMETHING\n1\n2\n3\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS\n0 1\n0 2\n0 3\nITEM: "
          "ATOMS id type x y z element\n3 2 0.5 0.5 0.5 Si\n");
  EXPECT_EQ(frame.LengthUnit, "µm");
  EXPECT_EQ(frame.Time, 0.25);
  EXPECT_EQ(frame.Step, 7);
  EXPECT_EQ(frame.Type, (std::vector<int>{ 2 }));
  EXPECT_FALSE(frame.Box->PeriodicityKnown); // an old header, without flags
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 1, 2, 3 }));
}

TEST(DumpGrammar, TiltedBoxes)
{
  // The header holds the bounding box of a cell of edges 10, 9, 8 and tilts 2.5, -1.5, 3 from 0
  const std::string box = "xy xz yz pp pp pp\n-1.5 12.5 2.5\n0 12 -1.5\n0 8 3";
  const PackFrame frame = Parse(Dump(box, "x y z", "1 1 1\n2 2 2\n"));
  EXPECT_EQ(frame.Box->Origin, (Vector3{ 0, 0, 0 }));
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 10, 9, 8 }));
  EXPECT_EQ(frame.Box->Tilts, (Vector3{ 2.5, -1.5, 3 }));
  const PackFrame scaled = Parse(Dump(box, "xs ys zs", "0 0 1\n0.5 0.5 0.5\n"));
  EXPECT_EQ(scaled.X, (Doubles{ -1.5, 5.5 }));
  EXPECT_EQ(scaled.Y, (Doubles{ 3, 6 }));
  EXPECT_EQ(scaled.Z, (Doubles{ 8, 4 }));
  const PackFrame negative =
    Parse(Dump("xy xz yz pp pp pp\n-3 10 -2\n-4 9 -1\n0 8 -4", "x y z", "1 1 1\n2 2 2\n"));
  EXPECT_EQ(negative.Box->Origin, (Vector3{ 0, 0, 0 }));
  EXPECT_EQ(negative.Box->Edges, (Vector3{ 10, 9, 8 }));
}

TEST(DumpGrammar, GeneralBoxesAreTurned)
{
  // Edges along z, x, y: the same cell as 4 x 3 x 5
  const PackFrame frame = Parse(Dump("abc origin pp pp ff\n0 0 4 1\n3 0 0 2\n0 5 0 3",
    "xs ys zs radius", "0.25 0.5 0.75 1\n0 0 0 1\n"));
  EXPECT_EQ(frame.Box->Origin, (Vector3{ 1, 2, 3 }));
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 4, 3, 5 }));
  EXPECT_EQ(frame.Box->Tilts, (Vector3{ 0, 0, 0 }));
  EXPECT_EQ(frame.Box->Periodic, (std::array<bool, 3>{ true, true, false }));
  EXPECT_NEAR(frame.X[0], 1 + 1.0, 1e-14);
  EXPECT_NEAR(frame.Y[0], 2 + 1.5, 1e-14);
  EXPECT_NEAR(frame.Z[0], 3 + 3.75, 1e-14);
  EXPECT_EQ(frame.Warnings.size(), 1u);
  // As LAMMPS puts them nothing is turned
  const PackFrame plain =
    Parse(Dump("abc origin pp pp pp\n10 0 0 0\n2.5 9 0 0\n-1.5 3 8 0", "x y z", "1 1 1\n2 2 2\n"));
  EXPECT_EQ(plain.Box->Tilts, (Vector3{ 2.5, -1.5, 3 }));
  EXPECT_TRUE(plain.Warnings.empty());
  // A left-handed cell is spanned by the opposite of its third edge, too
  const PackFrame left = Parse(
    Dump("abc origin pp pp pp\n4 0 0 0\n0 3 0 0\n0 0 -5 0", "xs ys zs", "0 0 0\n0.5 0.5 0.5\n"));
  EXPECT_EQ(left.Box->Origin, (Vector3{ 0, 0, -5 }));
  EXPECT_EQ(left.Box->Edges, (Vector3{ 4, 3, 5 }));
  EXPECT_EQ(left.Z, (Doubles{ 0, -2.5 }));
}

TEST(DumpGrammar, Frames)
{
  const std::string first = Dump(Cube, "x y z", "1 1 1\n2 2 2\n"),
                    last = Dump(Cube, "x y z", "3 3 3\n");
  auto file = OpenText(first + last);
  ASSERT_EQ(file.Frames.size(), 2u);
  EXPECT_EQ(file.Frame(0).X, (Doubles{ 1, 2 }));
  EXPECT_SAYS(file.Frame(1), "Frame 2: 2 rows are stated, the file has room for 1.");
  EXPECT_EQ(ruc::FrameTimes(file.Frames), (Doubles{ 0, 1 })); // the steps do not rise
  auto rubbish = OpenText(first + "rubbish\n" + first);
  ASSERT_EQ(rubbish.Frames.size(), 2u);
  EXPECT_EQ(rubbish.Frame(0).X, (Doubles{ 1, 2 }));
  EXPECT_SAYS(
    rubbish.Frame(1), "Frame 2: Line 12: a section 'ITEM: …' is required, got 'rubbish'.");
  EXPECT_EQ(OpenText(first + "\n\n").Frames.size(), 1u);
}

TEST(DumpGrammar, Refusals)
{
  const std::pair<std::string, const char*> texts[] = {
    { "ITEM: TIMESTEP\nx\n", "Line 2: TIMESTEP requires a whole number, got 'x'." },
    { "ITEM: TIME\nx\n", "Line 2: TIME requires a number" },
    { "ITEM: ATOMS x y z\n1 1 1\n", "'ITEM: NUMBER OF ATOMS' is required" },
    { "ITEM: TIMESTEP\n0\n", "'ITEM: ATOMS' is required, got the end of the file." },
    { "ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs ys zs\n1 1 1\n", "'ITEM: BOX BOUNDS' is required" },
    { Dump("pp pp pp\n0 1\n1 0\n0 1", "x y z", ""), "a box with edges > 0 is required" },
    { Dump("pp pp pp\n0 1\n0 a\n0 1", "x y z", ""),
      "2 numbers of the box are required, got '0 a'" },
    { Dump("pp pp pp\n0 1\n0 nan\n0 1", "x y z", ""), "2 numbers of the box are required" },
    { "ITEM: NUMBER OF ATOMS\n-1\nITEM: ATOMS x y z\n", "-1 rows are stated" },
    { "ITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS x y z\n", "At least one sphere is required" },
    { Dump(Cube, "x y z", "1 1 1 1\n1 1 1 1\n"), "3 fields are required, got 4." },
  };
  for (const auto& bad : texts)
  {
    EXPECT_SAYS(Parse(bad.first), bad.second);
  }
}

TEST(DataGrammar, StylesAndSections)
{
  const std::string head =
    "a title\n\n2 atoms\n1 atom types # more\n\n0 4 xlo xhi\n0 5 ylo yhi\n-3 3 zlo zhi\n";
  const PackFrame sphere = Parse(head +
    "\nMasses\n\n1 5\n\nAtoms # sphere\n\n1 1 2 7 1 2 3\n2 1 4 7 2 3 1 0 0 1\n\nVelocities\n\n1 1 "
    "1 1 1 1 1\n");
  EXPECT_EQ(sphere.Radius, (Doubles{ 1, 2 }));
  EXPECT_EQ(sphere.Z, (Doubles{ 3, 1 }));
  EXPECT_EQ(sphere.Box->Edges, (Vector3{ 4, 5, 6 }));
  EXPECT_FALSE(sphere.Box->PeriodicityKnown);
  EXPECT_EQ(Parse(head + "Atoms\n\n1 1 2 7 1 2 3\n2 1 4 7 2 3 1\n").Radius, (Doubles{ 1, 2 }));
  const PackFrame atomic = Parse(head + "Atoms # atomic\n\n1 1 1 2 3\n2 1 2 3 1\n");
  EXPECT_TRUE(atomic.Radius.empty());
  EXPECT_EQ(atomic.X, (Doubles{ 1, 2 }));
  EXPECT_EQ(Parse(head + "Atoms\n\n1 1 1 2 3\n2 1 2 3 1\n").Y, (Doubles{ 2, 3 }));
  EXPECT_SAYS(Parse(head + "Atoms # full\n\n1 1 1 1 1 1 1\n"),
    "the style sphere or atomic are required, got 'full'");
  EXPECT_SAYS(Parse(head + "Atoms\n\n1 1 1 1 1 1\n"),
    "id type diameter density x y z are required, got 6 columns");
  EXPECT_SAYS(Parse(head), "A section Atoms is required");
  EXPECT_SAYS(
    Parse(head + "Atoms\n\n1 1 2 7 1 2 3\n"), "2 rows are stated, the file has room for 1.");
  EXPECT_SAYS(Parse("t\n\n2 atoms\n4 0 xlo xhi\n"), "Line 4: a box with edges > 0 is required");
  EXPECT_EQ(Parse(head + "1 -1 0.5 xy xz yz\n\nAtoms # sphere\n\n1 1 2 7 1 2 3\n2 1 4 7 2 3 1\n")
              .Box->Tilts,
    (Vector3{ 1, -1, 0.5 }));
}

TEST(DataGrammar, GeneralBoxAndTitle)
{
  const PackFrame frame =
    Parse("LAMMPS data file, timestep = 12, units = cgs\n\n1 atoms\n4 0 0 avec\n1 3 0 bvec\n0 0 5 "
          "cvec\n1 2 3 abc origin\n\nAtoms # sphere\n\n1 1 2 7 1 2 3\n");
  EXPECT_EQ(frame.Box->Origin, (Vector3{ 1, 2, 3 }));
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 4, 3, 5 }));
  EXPECT_EQ(frame.Box->Tilts, (Vector3{ 1, 0, 0 }));
  EXPECT_EQ(frame.Step, 12);
  EXPECT_EQ(frame.LengthUnit, "cm");
}

TEST(DataGrammar, RadiiOfYade)
{
  // YADE's box holds the spheres closely, with what is written taken as radii
  const std::string rows = "Atoms\n\n1 1 0.5 7 1 2 3\n2 1 0.25 7 4 3 3\n";
  const PackFrame yade = Parse("LIGGGHTS Description\n\n2 atoms\n1 atom types\n\n0.5 4.25 xlo "
                               "xhi\n1.5 3.25 ylo yhi\n2.5 3.5 zlo zhi\n\n" +
    rows);
  EXPECT_EQ(yade.Radius, (Doubles{ 0.5, 0.25 }));
  EXPECT_EQ(yade.Warnings.size(), 1u);
  // Others write diameters under the same title
  const PackFrame other = Parse(
    "LIGGGHTS Description\n\n2 atoms\n1 atom types\n\n0 5 xlo xhi\n0 5 ylo yhi\n0 5 zlo zhi\n\n" +
    rows);
  EXPECT_EQ(other.Radius, (Doubles{ 0.25, 0.125 }));
}

TEST(XyzGrammar, KeysAndColumns)
{
  const PackFrame frame =
    Parse("2\nLattice=[[4,0,0], [1, 3, 0], [0,0,5]] pbc=[T, F, T] flag time = 0.5 note='a b'  "
          "Properties=force:R:3:ID:I:1:Position:R:3:Diameter:R:1:type:I:1:species:S:1\n"
          "9 9 9 2 1 2 3 1 5 A\n9 9 9 1 2.0D0 3 4 2 6 B\n");
  EXPECT_EQ(frame.X, (Doubles{ 1, 2 }));
  EXPECT_EQ(frame.Radius, (Doubles{ 0.5, 1 }));
  EXPECT_EQ(frame.Id, (std::vector<std::int64_t>{ 2, 1 }));
  EXPECT_EQ(frame.Type, (std::vector<int>{ 5, 6 })); // the type goes before the species
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 4, 3, 5 }));
  EXPECT_EQ(frame.Box->Tilts, (Vector3{ 1, 0, 0 }));
  EXPECT_EQ(frame.Box->Periodic, (std::array<bool, 3>{ true, false, true }));
  EXPECT_EQ(frame.Time, 0.5);
}

TEST(XyzGrammar, Defaults)
{
  const PackFrame plain = Parse("2\nwhat ever\nO 1 2 3\nH 4 5 6\n");
  EXPECT_EQ(plain.Z, (Doubles{ 3, 6 }));
  EXPECT_EQ(plain.TypeNames, (std::vector<std::string>{ "H", "O" }));
  EXPECT_FALSE(plain.Box);
  EXPECT_TRUE(plain.Radius.empty());
  const PackFrame lattice = Parse("1\nLattice=\"4 0 0 0 3 0 0 0 5\"\nO 1 2 3\n");
  EXPECT_EQ(lattice.Box->Periodic, (std::array<bool, 3>{ true, true, true }));
  auto frames =
    OpenText("1\nProperties=pos:R:3 time=2\n1 2 3\n1\nProperties=pos:R:3 time=3\n4 5 6\n\n");
  ASSERT_EQ(frames.Frames.size(), 2u);
  EXPECT_EQ(ruc::FrameTimes(frames.Frames), (Doubles{ 2, 3 }));
  EXPECT_EQ(frames.Frame(1).X, (Doubles{ 4 }));
}

TEST(XyzGrammar, Refusals)
{
  const std::pair<const char*, const char*> texts[] = {
    { "2\nProperties=pos:R:2:radius:R:1\n1 1 1\n1 1 1\n",
      "positions of 3 columns are required, got 2" },
    { "1\nProperties=pos:R\n1 1 1\n", "Properties requires name:type:count" },
    { "1\nProperties=id:I:1\n1\n", "Properties requires pos:R:3" },
    { "1\nProperties=pos:R:3 Lattice=\"1 0 0 1\"\n1 1 1\n",
      "Lattice requires 9 numbers and Origin 3, got 4 and 0" },
    { "1\nProperties=pos:R:3 Lattice=\"1 0 0 0 1 0 0 0 a\"\n1 1 1\n",
      "Lattice requires 9 numbers" },
    { "1\nProperties=pos:R:3 Lattice=\"1 0 0 2 0 0 0 0 1\"\n1 1 1\n",
      "three finite edges that span a volume" },
    { "1\nProperties=pos:R:3 Lattice=\"1 0 0 0 1 0 0 0 1\" pbc=\"T T\"\n1 1 1\n",
      "pbc requires three of T and F" },
    { "3\nProperties=pos:R:3\n1 1 1\n", "3 rows are stated, the file has room for 1." },
    { "99999999999\nProperties=pos:R:3\n1 1 1\n",
      "99999999999 rows are stated, the file has room for" },
  };
  for (const auto& bad : texts)
  {
    EXPECT_SAYS(Parse(bad.first), bad.second);
  }
}

TEST(LbpmGrammar, HeadersAndGhosts)
{
  const std::string head = "Number of Spheres: 2\nDomain Length (x,y,z):  4, 5, 6\nMedia porosity: "
                           "0.3\nlog(r) Normal\nMean\n";
  const PackFrame frame = Parse(head + "1 2 3 0.5\n4.1 3 3 0.25\n");
  EXPECT_EQ(frame.Format, "LBPM pack");
  EXPECT_EQ(frame.Radius, (Doubles{ 0.5, 0.25 }));
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 4, 5, 6 }));
  EXPECT_EQ(frame.Box->Periodic, (std::array<bool, 3>{ true, true, true }));
  const PackFrame bounds = Parse("0 4\n-1 4\n0 6\n1 2 3 0.5\n3 \t 3 \t 3 \t 0.25\n\n");
  EXPECT_EQ(bounds.Box->Origin, (Vector3{ 0, -1, 0 }));
  EXPECT_EQ(bounds.Z, (Doubles{ 3, 3 }));
  const ruc::FramePack pack =
    OpenText("0 4\n0 5\n0 6\n1 2 3 0.5\n5 2 3 0.5\n3.5 1 1 0.25\n").Pack();
  EXPECT_EQ(pack.Ghosts, 1u);
  EXPECT_EQ(pack.Pack.X, (Doubles{ 1, 3.5 }));
  EXPECT_SAYS(Parse(head + "1 2 3 0.5\n"), "2 rows are required, got 1.");
  EXPECT_SAYS(
    Parse("a: 2\nDomain Length: 4, 5\n\n\n\n1 1 1 1\n"), "Domain Length requires three numbers");
  EXPECT_SAYS(Parse("0 4\n5 0\n0 6\n1 2 3 0.5\n"), "Line 2: two rising numbers are required");
}

TEST(SkogeGrammar, Species)
{
  const std::string cell = "4 0 0\n0 5 0\n0 0 6\nT T F\n";
  const PackFrame species = Parse("3\n3 2\n1 2\n0.5 1\n" + cell + "1 1 1\n2 2 2\n3 3 3\n");
  EXPECT_EQ(species.Radius, (Doubles{ 0.25, 0.5, 0.5 }));
  EXPECT_EQ(species.Type, (std::vector<int>{ 1, 2, 2 }));
  EXPECT_EQ(species.Box->Periodic, (std::array<bool, 3>{ true, true, false }));
  // Both are written: the column holds
  EXPECT_EQ(
    Parse("3\n3 2\n1 2\n0.5 1\n" + cell + "1 1 1 0.75\n2 2 2 1.5\n3 3 3 1.5\n").Radius[0], 0.375);
  EXPECT_EQ(Parse("3\n1 1\n1\n" + cell + "1 1 1 0.5\n").Radius[0], 0.25);
  // Nine species: what could be edges are diameters
  EXPECT_EQ(Parse("3\n9 9\n1 1 1 1 1 1 1 1 1\n1 2 3 4 5 6 7 8 9\n" + cell +
              "1 1 1\n2 1 1\n3 1 1\n1 2 1\n1 3 1\n1 1 2\n1 1 3\n1 1 4\n1 1 5\n")
              .Radius[8],
    4.5);
  EXPECT_SAYS(Parse("2\n1 1\n1\n1\n4 0 0 5\nT T T\n1 1\n"), "3 dimensions are required");
  EXPECT_SAYS(Parse("3\n1 1\n1\n" + cell + "1 1 1\n"), "diameters are required");
  EXPECT_SAYS(Parse("3\n3 2\n1 1\n0.5 1\n" + cell + "1 1 1\n"),
    "species of 3 spheres in all are required, got 2");
  EXPECT_SAYS(Parse("3\n1 1\n1\n1\n4 0 0 0 5 0\nT T T\n1 1 1\n"), "10 or 11 numbers are required");
  EXPECT_SAYS(
    Parse("3\n2 1\n2\n1\n" + cell + "1 1 1\n"), "2 rows are stated, the file has room for 1.");
  EXPECT_SAYS(Parse("3\n1 1\n1\n-1\n" + cell + "1 1 1\n"), "Diameters > 0 are required");
}

TEST(MercuryGrammar, Frames)
{
  const std::string row = "0.5 0.5 0.5 0 0 0 0.25 0 0 0 0 0 0 4\n";
  auto file = OpenText("1 0.5 0 0 0 1 2 3 \n" + row + "2 0.75 0 0 0 1 2 3\n" + row);
  ASSERT_EQ(file.Frames.size(), 2u);
  const PackFrame frame = file.Frame(0);
  EXPECT_EQ(frame.Radius, (Doubles{ 0.25 }));
  EXPECT_EQ(frame.Type, (std::vector<int>{ 4 }));
  EXPECT_EQ(frame.Time, 0.5);
  EXPECT_EQ(frame.Box->Edges, (Vector3{ 1, 2, 3 }));
  EXPECT_FALSE(frame.Box->PeriodicityKnown);
  EXPECT_SAYS(file.Frame(1), "Frame 2: 2 rows are stated, the file has room for 1.");
  auto flat = OpenText("1 0 0 0 0 1 1 1\n" + row + "1 0 0 0 1 1\n" + row); // two dimensions have 6
  EXPECT_SAYS(
    flat.Frame(1), "a header 'N t xmin ymin zmin xmax ymax zmax' of three dimensions is required");
}

TEST(EsysGrammar, SectionsAndRefusals)
{
  const std::string head = "LSMGeometry 1.2\nBoundingBox 0 0 0 4 5 6\nPeriodicBoundaries 1 0 1\n";
  const std::string rows = "BeginParticles\nSimple\n1\n1 2 3 0.5 7 9\n";
  const PackFrame frame = Parse(head + "Dimension 3D\n" + rows); // without EndParticles
  EXPECT_EQ(frame.Id, (std::vector<std::int64_t>{ 7 }));
  EXPECT_EQ(frame.Type, (std::vector<int>{ 9 }));
  EXPECT_EQ(frame.Box->Periodic, (std::array<bool, 3>{ true, false, true }));
  EXPECT_SAYS(
    Parse(head + "Dimension 2D\n" + rows), "Dimension 3D is required, got 'Dimension 2D'");
  EXPECT_SAYS(Parse(head), "BeginParticles is required, got the end of the file");
  EXPECT_SAYS(Parse(head + "BeginParticles\nRotSphere\n"), "particles 'Simple' are required");
  EXPECT_SAYS(Parse(head + "BeginParticles\nSimple\n2\n1 2 3 0.5 7 9\n"),
    "2 rows are stated, the file has room for 1.");
  EXPECT_SAYS(Parse("LSMGeometry 1.2\nBoundingBox 0 0 0 4\n"), "Line 2: 6 numbers are required");
}

TEST(YadeGrammar, ColumnsOfTheFirstLine)
{
  const PackFrame plain = Parse("#format x_y_z_r\n1\t2\t3\t0.5\n4\t5\t6\t0.25\n");
  EXPECT_EQ(plain.Format, "YADE text");
  EXPECT_EQ(plain.Radius, (Doubles{ 0.5, 0.25 }));
  const PackFrame material = Parse("#format x_y_z_r_matId\n# text\n1 2 3 0.5 7\n");
  EXPECT_EQ(material.Type, (std::vector<int>{ 7 }));
  const PackFrame clump = Parse("#format x_y_z_r_clumpId\n1 2 3 0.5 -1\n");
  EXPECT_TRUE(clump.Type.empty());
  const PackFrame id = Parse("#format id_x_y_z_r_matId\n8 1 2 3 0.5 7\n");
  EXPECT_EQ(id.Id, (std::vector<std::int64_t>{ 8 }));
  const PackFrame attributes = Parse("#format x_y_z_r_attrs\n# x y z r vx vy\n1 2 3 0.5 7 8\n");
  EXPECT_EQ(attributes.Radius, (Doubles{ 0.5 }));
  EXPECT_SAYS(Parse("#format x_y_z_r\n1 2 3 0.5 7\n"),
    "Columns requires a name for each of 5 columns, got 4");
}
