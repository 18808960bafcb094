// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One pack in every format: each file equals the truth to the file's digits. And what is wrong is
// refused for its own reason.
#include "FormatFiles.h"

#include <map>

namespace
{
using formats::DataFile;
using formats::OpenFile;
using ruc::FramePack;

const ruc::Vector3 Origin = { -1, 2, 0.5 }, Edges = { 10, 12, 14 };

struct Truth
{
  ruc::SpherePack Pack;
  std::vector<int> Type; // 1, 2, 3 by radius
};

const Truth& TheTruth()
{
  static const Truth truth = []()
  {
    Truth read;
    std::ifstream file(DataFile("same_pack/truth.csv"));
    std::string row;
    for (std::getline(file, row); std::getline(file, row);)
    {
      std::replace(row.begin(), row.end(), ',', ' ');
      std::int64_t id = 0;
      int type = 0;
      double x = 0.0, y = 0.0, z = 0.0, radius = 0.0;
      std::istringstream(row) >> id >> type >> x >> y >> z >> radius;
      read.Pack.Id.push_back(id);
      read.Pack.X.push_back(x);
      read.Pack.Y.push_back(y);
      read.Pack.Z.push_back(z);
      read.Pack.Radius.push_back(radius);
      read.Type.push_back(radius < 0.4 ? 1 : radius < 0.5 ? 2 : 3);
    }
    return read;
  }();
  return truth;
}

double Distance(double a, double b, int axis)
{
  const double d = std::abs(a - b);
  return std::min(d, std::abs(d - Edges[axis]));
}

struct Sample
{
  const char* File;
  const char* Format;
  std::size_t Frames;
  double Digits;      // no coordinate differs by more
  ruc::Vector3 Shift; // of the file's origin from the truth's
  bool Ordered;       // the order of ids is the truth's
};

std::ostream& operator<<(std::ostream& out, const Sample& sample)
{
  return out << sample.File;
}

constexpr ruc::Vector3 None = { 0, 0, 0 }, AtZero = { 1, -2, -0.5 }, AtCentre = { -4, -8, -7.5 };
const Sample Samples[] = {
  { "lammps_frames.dump", "LAMMPS dump", 3, 1e-12, None, true },
  { "lammps_scaled.dump", "LAMMPS dump", 1, 1e-8, None, true },
  { "lammps_unwrapped.dump", "LAMMPS dump", 1, 1e-8, None, true },
  { "lammps_scaled_unwrapped.dump", "LAMMPS dump", 1, 1e-8, None, true },
  { "lammps_custom.dump.gz", "LAMMPS dump", 1, 1e-12, None, true },
  { "lammps_write.data", "LAMMPS data", 1, 1e-12, None, true },
  { "ase.extxyz", "extended XYZ", 2, 1e-8, AtZero, true },
  { "ovito_origin.xyz", "extended XYZ", 1, 1e-12, None, true },
  { "hoomd.gsd", "HOOMD GSD", 3, 2e-6, AtCentre, true },
  { "packing.xyzd", "Baranau xyzd", 1, 1e-12, AtZero, true },
  { "packlsd_species.dat", "Donev, Skoge", 1, 1e-12, AtZero, false },
  { "packlsd_poly.dat", "Donev, Skoge", 1, 1e-12, AtZero, false },
  { "mercury.data", "MercuryDPM data", 2, 1e-12, None, true },
  { "esys.geo", "ESyS-Particle geometry", 1, 1e-12, None, true },
  { "comment_header.csv", "table", 1, 1e-12, None, true },
  { "truth.csv", "table", 1, 1e-12, None, true },
  { "yade_matid.txt", "YADE text", 1, 1e-4, None, true },
  { "yade_attrs.txt", "YADE text", 1, 1e-4, None, true },
};

// Spheres in the order of the truth, which is that of x where the file has another
std::vector<std::size_t> OrderOf(const FramePack& read, const Sample& sample)
{
  std::vector<std::size_t> order(read.Pack.Size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  if (!sample.Ordered)
  {
    const ruc::SpherePack& truth = TheTruth().Pack;
    std::map<std::array<long, 3>, std::size_t> found;
    const auto key = [](const ruc::Vector3& centre)
    {
      return std::array<long, 3>{ std::lround(1e6 * centre[0]), std::lround(1e6 * centre[1]),
        std::lround(1e6 * centre[2]) };
    };
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ruc::Vector3 centre = read.Pack.Centre(i);
      for (int q = 0; q < 3; ++q)
      {
        centre[q] -= sample.Shift[q];
      }
      found[key(centre)] = i;
    }
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const auto at = found.find(key(truth.Centre(i)));
      EXPECT_NE(at, found.end()) << "sphere " << i << " of the truth";
      order[i] = at == found.end() ? 0 : at->second;
    }
  }
  return order;
}

void ExpectTruth(const FramePack& read, const Sample& sample, const ruc::Vector3& moved = None)
{
  const auto& [truth, types] = TheTruth();
  ASSERT_EQ(read.Pack.Size(), truth.Size());
  ASSERT_EQ(read.Pack.Id.size(), truth.Size());
  EXPECT_EQ(read.Format, sample.Format);
  const std::vector<std::size_t> order = OrderOf(read, sample);
  for (std::size_t i = 0; i < truth.Size(); ++i)
  {
    const ruc::Vector3 centre = read.Pack.Centre(order[i]), true_ = truth.Centre(i);
    for (int q = 0; q < 3; ++q)
    {
      ASSERT_LE(Distance(centre[q] - sample.Shift[q] - moved[q], true_[q], q), sample.Digits)
        << "sphere " << i << " axis " << q;
    }
    ASSERT_NEAR(read.Pack.Radius[order[i]], truth.Radius[i], std::max(sample.Digits, 1e-12)) << i;
  }
}
}

class SamePack : public testing::TestWithParam<Sample>
{
};

TEST_P(SamePack, EqualsTheTruth)
{
  const Sample& sample = GetParam();
  auto file = OpenFile(DataFile(std::string("same_pack/") + sample.File));
  ASSERT_EQ(file.Frames.size(), sample.Frames);
  ExpectTruth(file.Pack(), sample);
}

INSTANTIATE_TEST_SUITE_P(Files, SamePack, testing::ValuesIn(Samples),
  [](const auto& sample)
  {
    std::string name = sample.param.File;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
  });

TEST(SamePackDetails, FramesOfADump)
{
  auto file = OpenFile(DataFile("same_pack/lammps_frames.dump"));
  ExpectTruth(file.Pack(1), Samples[0], { 0.25, 0, 0 });
  ExpectTruth(file.Pack(2), Samples[0], { 0.25, 0.5, 0 });
  ExpectTruth(file.Pack(0), Samples[0]); // in any order
  const FramePack last = file.Pack(2);
  EXPECT_EQ(last.LengthUnit, "m"); // told in the first frame alone
  EXPECT_EQ(last.Type, TheTruth().Type);
  ASSERT_TRUE(last.Box);
  EXPECT_TRUE(last.BoxIsWindow);
  EXPECT_EQ(*last.Box, ruc::Window::MakeBox(Origin, Edges, { true, true, true }));
  EXPECT_EQ(last.Pack.Id, TheTruth().Pack.Id);
  EXPECT_EQ(ruc::FrameTimes(file.Frames).size(), 3u);
  EXPECT_EQ(ruc::FrameTimes(file.Frames)[0], 0.0);
}

TEST(SamePackDetails, UnwrappedCentresAreWrapped)
{
  EXPECT_EQ(OpenFile(DataFile("same_pack/lammps_scaled.dump")).Pack().Wrapped, 0u);
  EXPECT_GT(OpenFile(DataFile("same_pack/lammps_unwrapped.dump")).Pack().Wrapped, 300u);
}

TEST(SamePackDetails, FramesOfGsd)
{
  auto file = OpenFile(DataFile("same_pack/hoomd.gsd"));
  EXPECT_EQ(ruc::FrameTimes(file.Frames), (std::vector<double>{ 0, 100, 200 }));
  for (int n = 0; n < 3; ++n)
  {
    const FramePack pack = file.Pack(static_cast<std::size_t>(n));
    ExpectTruth(pack, Samples[8], { 0.25 * n, 0, 0 });
    EXPECT_EQ(*pack.Box, ruc::Window::MakeBox({ -5, -6, -7 }, Edges, { true, true, true }));
    EXPECT_EQ(pack.Time, 100.0 * n);
    std::vector<int> types = TheTruth().Type;
    for (int& type : types)
    {
      --type; // counted from 0, in frame 0 alone
    }
    EXPECT_EQ(pack.Type, types);
  }
}

TEST(SamePackDetails, OtherFrames)
{
  auto ase = OpenFile(DataFile("same_pack/ase.extxyz"));
  EXPECT_EQ(ruc::FrameTimes(ase.Frames)[0], 0.0);
  EXPECT_EQ(ase.Pack(1).TypeNames, (std::vector<std::string>{ "C", "H", "O" }));
  auto mercury = OpenFile(DataFile("same_pack/mercury.data"));
  EXPECT_EQ(ruc::FrameTimes(mercury.Frames), (std::vector<double>{ 0, 0.5 }));
  EXPECT_EQ(mercury.Pack(1).Type, TheTruth().Type);
  EXPECT_EQ(mercury.Pack(1).Time, 0.5);
}

TEST(SamePackDetails, BoxesAndTypes)
{
  const auto pack = [](const char* name)
  { return OpenFile(DataFile(std::string("same_pack/") + name)).Pack(); };
  const FramePack ovito = pack("ovito_origin.xyz");
  EXPECT_EQ(*ovito.Box, ruc::Window::MakeBox(Origin, Edges, { true, true, false }));
  EXPECT_FALSE(ovito.BoxIsWindow);
  EXPECT_EQ(ovito.Type, TheTruth().Type);
  for (const char* unknown : { "lammps_write.data", "mercury.data" })
  {
    const FramePack read = pack(unknown);
    EXPECT_EQ(*read.Box, ruc::Window::MakeBox(Origin, Edges, { false, false, false })) << unknown;
    EXPECT_FALSE(read.BoxIsWindow);
    EXPECT_EQ(read.Type, TheTruth().Type);
  }
  EXPECT_EQ(pack("lammps_write.data").LengthUnit, "m");
  ruc::PackSettings periodic;
  periodic.Periodic = { true, true, true };
  EXPECT_TRUE(OpenFile(DataFile("same_pack/mercury.data")).Pack(0, periodic).BoxIsWindow);
  for (const char* whole : { "packing.xyzd", "packlsd_poly.dat", "ase.extxyz" })
  {
    EXPECT_EQ(*pack(whole).Box, ruc::Window::MakeBox({ 0, 0, 0 }, Edges, { true, true, true }));
    EXPECT_TRUE(pack(whole).BoxIsWindow) << whole;
  }
  const FramePack esys = pack("esys.geo");
  EXPECT_TRUE(esys.BoxIsWindow);
  EXPECT_EQ(esys.Pack.Id.front(), 0);
  EXPECT_EQ(esys.Type, TheTruth().Type);
}

TEST(SamePackDetails, RadiiByType)
{
  auto file = OpenFile(DataFile("same_pack/lammps_atom_no_radius.dump"));
  EXPECT_SAYS(file.Pack(), "requires radii: ");
  ruc::PackSettings settings;
  settings.RadiusByType = "1=0.3; 2=0.42, 3=0.6";
  // Six digits of a fraction of the edges
  ExpectTruth(file.Pack(0, settings), { "", "LAMMPS dump", 1, 1e-5, None, true });
  settings.RadiusByType = "1=0.3; 2=0.42";
  EXPECT_SAYS(file.Pack(0, settings), "RadiusByType requires a radius of type 3");
  settings.UniformRadius = 0.5;
  EXPECT_EQ(file.Pack(0, settings).Pack.Radius[0], 0.5);
}

TEST(SamePackDetails, Tables)
{
  const auto pack = [](const char* name)
  { return OpenFile(DataFile(std::string("same_pack/") + name)).Pack(); };
  EXPECT_EQ(pack("truth.csv").Type, TheTruth().Type);
  EXPECT_EQ(pack("comment_header.csv").Pack.Id, TheTruth().Pack.Id);
  std::vector<int> materials = pack("yade_matid.txt").Type;
  for (int& material : materials)
  {
    ++material; // counted from 0
  }
  EXPECT_EQ(materials, TheTruth().Type);
  EXPECT_SAYS(pack("no_header_id_first.txt"),
    "Line 1: 5 columns without names: set Columns, such as id,x,y,z,r.");
  for (const char* vtk : { "diameter.vtk", "liggghts_like_radius.vtp" })
  {
    EXPECT_SAYS(pack(vtk), "got one of VTK: open it by ParaView's own reader");
    formats::FileBytes bytes(DataFile(std::string("same_pack/") + vtk));
    EXPECT_EQ(ruc::FindFormat(bytes), nullptr);
  }
  EXPECT_SAYS(pack("positions_only.csv"), "X is in mm, Diameter in um: one unit is required.");
  auto nameless = OpenFile(DataFile("same_pack/no_header_id_first.txt"));
  nameless.Settings.Columns = "id,x,y,z,r";
  ExpectTruth(nameless.Pack(), { "", "table", 1, 1e-12, None, true });
}

// Whatever format the user says a file has: it is read or refused, and nothing else
TEST(ForcedFormats, ReadOrRefuse)
{
  for (const ruc::PackFormat* format : ruc::PackFormats())
  {
    for (const Sample& sample : Samples)
    {
      SCOPED_TRACE(std::string(format->Name) + " of " + sample.File);
      const std::string text = formats::TextOf(DataFile(std::string("same_pack/") + sample.File));
      ruc::MemoryBytes bytes(text);
      const auto frames = format->Scan(bytes);
      ASSERT_FALSE(frames.empty());
      const auto read = [&]() { ruc::MakePack(ruc::ReadFrame(*format, bytes, frames, 0, {}), {}); };
      EXPECT_NE(oracle::MessageOf(read), "<another exception>");
      if (format->Name == std::string(sample.Format))
      {
        EXPECT_EQ(format->Recognise(text.substr(0, 4096)), text.substr(0, 2) != "\x1f\x8b");
      }
    }
  }
}

TEST(BadFiles, AreRefusedForTheirReason)
{
  const std::pair<const char*, const char*> files[] = {
    { "truncated.dump", "500 rows are required, got " },
    { "1e12_atoms.dump", "1000000000000 rows are stated, the file has room for " },
    { "duplicate_id.dump", " stands in rows " },
    { "nan.dump", "requires a finite number, got 'nan'" },
    { "zero_radius.dump", "column 3 ('radius') requires a number > 0, got '0'" },
    { "mixed_coordinates.dump", "positions of one kind are required" },
    { "decimal_comma.csv", "requires a decimal point, got '5,3716'" },
    { "container_sphere.xyz", "Row 21 holds all others: a container?" },
    { "bomb.dump.gz", "Line 5: a line of at most 65536 bytes is required" },
    { "big_endian.xyzd", "Little-endian numbers are required" },
    { "odd_size.xyzd", "Little-endian numbers are required" },
  };
  for (const auto& bad : files)
  {
    SCOPED_TRACE(bad.first);
    EXPECT_SAYS(OpenFile(DataFile(std::string("bad/") + bad.first)).Pack(), bad.second);
  }
}
