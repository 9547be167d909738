// PCD 0.7, the point cloud format of the Point Cloud Library: a text header, then points as text (ascii), as records
// (binary), or column by column under LZF (binary_compressed). Multi-byte numbers are little-endian.
// Source: pointclouds.org, "The PCD (Point Cloud Data) file format".

#include <fmt/format.h>
#include <lzf.h>
#include <map>

#include "core/detection_files/detection_format.h"
#include "core/detection_files/header_lines.h"
#include "core/detection_files/point_table.h"
#include "core/text.h"

namespace core {

namespace {

/// Where one field lies: its first number in a point, of `count`.
struct Field {
  std::string name;
  NumberType type = NumberType::kF32;
  std::size_t count = 1;   // numbers in a point
  std::size_t offset = 0;  // bytes from the beginning of a point
  std::size_t word = 0;    // words from the beginning of a line of text

  [[nodiscard]] std::size_t size() const { return sizeOf(type) * count; }
};

struct Header {
  std::vector<Field> fields;
  std::size_t points = 0;
  std::string data;       // ascii, binary, binary_compressed
  std::size_t begin = 0;  // byte at which the points begin
  int line = 0;           // last line of the header

  [[nodiscard]] std::size_t pointSize() const { return fields.back().offset + fields.back().size(); }
  [[nodiscard]] std::size_t words() const { return fields.back().word + fields.back().count; }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Field& field : fields) names.push_back(field.name);
    return names;
  }
};

/// The lines of the header by their first word.
using Entries = std::map<std::string, std::pair<std::vector<std::string>, Place>>;

InputError damaged(const Place& place, const std::string& problem) {
  return {place, problem, "Copy or export the file again."};
}

NumberType typeOf(const Place& place, const std::string& type, const std::string& size) {
  static const std::map<std::string, NumberType> known{
      {"I1", NumberType::kI8},  {"U1", NumberType::kU8},  {"I2", NumberType::kI16}, {"U2", NumberType::kU16},
      {"I4", NumberType::kI32}, {"U4", NumberType::kU32}, {"I8", NumberType::kI64}, {"U8", NumberType::kU64},
      {"F4", NumberType::kF32}, {"F8", NumberType::kF64}};
  const auto found = known.find(type + size);
  if (found != known.end()) return found->second;
  throw damaged(place, fmt::format("a field of TYPE {} and SIZE {} is unknown.", type, size));
}

std::pair<std::vector<std::string>, Place> entry(const Entries& entries, const std::filesystem::path& file,
                                                 const std::string& key) {
  const auto found = entries.find(key);
  if (found == entries.end()) throw damaged({.file = file}, "the header has no line " + key + ".");
  return found->second;
}

std::vector<Field> fieldsOf(const Entries& entries, const std::filesystem::path& file) {
  const auto [names, place] = entry(entries, file, entries.contains("COLUMNS") ? "COLUMNS" : "FIELDS");
  const auto [types, types_place] = entry(entries, file, "TYPE");
  const auto [sizes, sizes_place] = entry(entries, file, "SIZE");
  const std::vector<std::string> counts =
      entries.contains("COUNT") ? entry(entries, file, "COUNT").first : std::vector<std::string>(names.size(), "1");
  if (names.empty() || types.size() != names.size() || sizes.size() != names.size() || counts.size() != names.size()) {
    throw damaged(place, "FIELDS, SIZE, TYPE and COUNT do not have the same number of entries.");
  }
  std::vector<Field> fields;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Field field{names[i], typeOf(types_place, types[i], sizes[i]), countOf(place, "COUNT", counts[i], 1e6)};
    if (!fields.empty()) {
      field.offset = fields.back().offset + fields.back().size();
      field.word = fields.back().word + fields.back().count;
    }
    fields.push_back(field);
  }
  return fields;
}

std::size_t pointsOf(const Entries& entries, const std::filesystem::path& file) {
  if (entries.contains("POINTS")) {
    const auto [words, place] = entry(entries, file, "POINTS");
    return countOf(place, "POINTS", join(words, " "));
  }
  const auto [width, width_place] = entry(entries, file, "WIDTH");
  const auto [height, height_place] = entry(entries, file, "HEIGHT");
  return countOf(width_place, "WIDTH", join(width, " "), 1e6) * countOf(height_place, "HEIGHT", join(height, " "), 1e6);
}

/// Whether points are relative to the sensor's pose or already moved by it is not agreed upon among programs.
void refuseViewpoint(const Entries& entries) {
  const auto found = entries.find("VIEWPOINT");
  if (found == entries.end()) return;
  const auto& [words, place] = found->second;
  const std::vector<double> origin{0, 0, 0, 1, 0, 0, 0};
  for (std::size_t i = 0; i < words.size() && i < origin.size(); ++i) {
    if (numberOf(place, "VIEWPOINT", words[i]) == origin[i]) continue;
    throw InputError(place, "VIEWPOINT is not the origin; it does not say in which frame the points are.",
                     "Write the points in the sensor's own frame and VIEWPOINT 0 0 0 1 0 0 0.");
  }
}

Header readHeader(const std::filesystem::path& file, std::string_view content) {
  HeaderLines lines(file, content);
  Entries entries;
  while (true) {
    const auto words = lines.next();
    if (!words) throw damaged({.file = file}, "ends before the line DATA of its header.");
    if (words->empty() || words->front().starts_with('#')) continue;
    entries[words->front()] = {{words->begin() + 1, words->end()}, lines.place()};
    if (words->front() == "DATA") break;
  }
  refuseViewpoint(entries);
  const auto [data, place] = entry(entries, file, "DATA");
  Header header{.fields = fieldsOf(entries, file),
                .points = pointsOf(entries, file),
                .data = join(data, " "),
                .begin = lines.offset(),
                .line = lines.line()};
  if (header.data != "ascii" && header.data != "binary" && header.data != "binary_compressed") {
    throw InputError(place, "DATA '" + header.data + "' is an unknown compression.",
                     "Known are ascii, binary and binary_compressed.");
  }
  return header;
}

PointTable emptyTable(const Header& header, const std::vector<WantedField>& wanted) {
  PointTable table;
  for (const WantedField& field : wanted) {
    table.columns.push_back({field.name, header.fields[field.index].type, {}});
    table.columns.back().values.reserve(header.points);
  }
  return table;
}

// -- ascii

Detections readAscii(const DetectionSource& source, const Header& header, const std::vector<WantedField>& wanted) {
  if (header.points > source.content.size()) {  // a point has a byte at least: checked before memory is asked for
    throw damaged({.file = source.file},
                  fmt::format("announces {} points in {} bytes.", header.points, source.content.size()));
  }
  PointTable table = emptyTable(header, wanted);
  std::vector<int> at_line;
  HeaderLines lines(source.file, source.content);
  while (lines.line() < header.line) (void)lines.next();
  while (at_line.size() < header.points) {
    const auto words = lines.next();
    if (!words) {
      throw damaged(lines.place(),
                    fmt::format("ends after {} of {} points; it is cut off.", at_line.size(), header.points));
    }
    if (words->empty()) continue;
    if (words->size() != header.words()) {
      throw damaged(lines.place(), fmt::format("has {} numbers; a point has {}.", words->size(), header.words()));
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const Field& field = header.fields[wanted[k].index];
      table.columns[k].values.push_back(numberOf(lines.place(), "field '" + field.name + "'", (*words)[field.word]));
    }
    at_line.push_back(lines.line());
  }
  return detectionsOf(
      table, [&](std::size_t point) { return Place{.file = source.file, .line = at_line[point], .item = ""}; });
}

// -- binary and binary_compressed: the same numbers, point by point or field by field

struct Layout {
  std::string_view bytes;
  bool by_field = false;
  std::size_t begin = 0;  // of the points in the file, for messages; 0 if they were compressed
};

Detections readNumbers(const DetectionSource& source, const Header& header, const std::vector<WantedField>& wanted,
                       const Layout& layout) {
  PointTable table = emptyTable(header, wanted);
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Field& field = header.fields[wanted[k].index];
    const std::size_t first = layout.by_field ? field.offset * header.points : field.offset;
    const std::size_t step = layout.by_field ? field.size() : header.pointSize();
    for (std::size_t i = 0; i < header.points; ++i) {
      table.columns[k].values.push_back(loadNumber(layout.bytes.data() + first + i * step, field.type));
    }
  }
  return detectionsOf(table, [&](std::size_t point) {
    const std::string at = layout.by_field ? "" : fmt::format(" (byte {})", layout.begin + point * header.pointSize());
    return Place{.file = source.file, .line = 0, .item = fmt::format("point {}{}", point + 1, at)};
  });
}

Detections readBinary(const DetectionSource& source, const Header& header, const std::vector<WantedField>& wanted) {
  const std::size_t there = source.content.size() - header.begin;
  if (header.points > there / header.pointSize()) {
    throw damaged({.file = source.file, .item = fmt::format("byte {}", source.content.size())},
                  fmt::format("is cut off: {} points of {} bytes were announced, {} bytes follow the header.",
                              header.points, header.pointSize(), there));
  }
  return readNumbers(source, header, wanted, {.bytes = source.content.substr(header.begin), .begin = header.begin});
}

Detections readCompressed(const DetectionSource& source, const Header& header, const std::vector<WantedField>& wanted) {
  if (header.points == 0) return readNumbers(source, header, wanted, {.bytes = "", .by_field = true});
  const Place place{.file = source.file, .item = fmt::format("byte {}", header.begin)};
  const std::string_view rest = source.content.substr(header.begin);
  if (rest.size() < 8) throw damaged(place, "is cut off: the sizes of the compressed points are missing.");
  const auto packed = static_cast<std::size_t>(loadNumber(rest.data(), NumberType::kU32));
  const auto unpacked = static_cast<std::size_t>(loadNumber(rest.data() + 4, NumberType::kU32));
  if (packed > rest.size() - 8) {
    throw damaged(place,
                  fmt::format("is cut off: {} compressed bytes were announced, {} follow.", packed, rest.size() - 8));
  }
  constexpr std::size_t kMostExpansion = 100;  // LZF turns 3 bytes into 264 at most
  if (header.points > unpacked / header.pointSize() || unpacked != header.points * header.pointSize() ||
      unpacked > kMostExpansion * packed) {
    throw damaged(place,
                  fmt::format("announces {} bytes of points in {} compressed ones; the header asks for {} points "
                              "of {} bytes.",
                              unpacked, packed, header.points, header.pointSize()));
  }
  std::string bytes(unpacked, '\0');
  if (lzf_decompress(rest.data() + 8, static_cast<unsigned>(packed), bytes.data(), static_cast<unsigned>(unpacked)) !=
      unpacked) {
    throw damaged(place, "the compressed points are damaged.");
  }
  return readNumbers(source, header, wanted, {.bytes = bytes, .by_field = true});
}

Detections read(const DetectionSource& source) {
  const Header header = readHeader(source.file, source.content);
  const auto wanted = wantedFields(source.file, source.columns, header.names());
  if (header.data == "ascii") return readAscii(source, header, wanted);
  return header.data == "binary" ? readBinary(source, header, wanted) : readCompressed(source, header, wanted);
}

/// The header begins with comments and then VERSION, or FIELDS in old files.
bool recognises(std::string_view content) {
  HeaderLines lines("", content.substr(0, 4096));
  while (const auto words = lines.next()) {
    if (words->empty() || words->front().starts_with('#')) continue;
    return words->front() == "VERSION" || words->front() == "FIELDS" || words->front() == "COLUMNS";
  }
  return false;
}

// -- writing

std::string headerOf(const PointTable& table, const std::string& encoding) {
  std::string fields, sizes, types, counts;
  for (const PointTable::Column& column : table.columns) {
    fields += " " + column.name;
    sizes += fmt::format(" {}", sizeOf(column.type));
    types += isReal(column.type) ? " F" : " I";
    counts += " 1";
  }
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\nWIDTH {}\n"
      "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n",
      fields, sizes, types, counts, table.size(), table.size(), encoding);
}

std::string compressed(const PointTable& table) {
  std::string bytes;
  for (const PointTable::Column& column : table.columns) {
    for (const double value : column.values) appendNumber(bytes, value, column.type);
  }
  constexpr std::size_t kMost = 0xffff'ffff;
  if (bytes.size() > kMost) {
    throw InputError({}, "has too many points for binary_compressed.", "Choose the encoding binary.");
  }
  std::string packed(bytes.size() + bytes.size() / 16 + 64, '\0');  // LZF adds one byte to every 32 at worst
  const unsigned size = bytes.empty() ? 0
                                      : lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), packed.data(),
                                                     static_cast<unsigned>(packed.size()));
  std::string out;
  appendNumber(out, size, NumberType::kU32);
  appendNumber(out, static_cast<double>(bytes.size()), NumberType::kU32);
  return out.append(packed, 0, size);
}

std::string records(const PointTable& table) {
  std::string out;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (const PointTable::Column& column : table.columns) appendNumber(out, column.values[i], column.type);
  }
  return out;
}

std::string lines(const PointTable& table) {
  std::string out;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (const PointTable::Column& column : table.columns) {
      if (&column != table.columns.data()) out += ' ';
      out += shortestNumber(column.values[i]);
    }
    out += '\n';
  }
  return out;
}

std::string write(const Detections& detections, const std::string& encoding) {
  const PointTable table = tableOf(detections);
  const std::string header = headerOf(table, encoding);
  if (encoding == "ascii") return header + lines(table);
  return header + (encoding == "binary" ? records(table) : compressed(table));
}

}  // namespace

DetectionFormat pcdFormat() {
  return {.name = "pcd",
          .title = "PCD point cloud",
          .endings = {".pcd"},
          .encodings = {"binary", "binary_compressed", "ascii"},
          .recognises = recognises,
          .read = read,
          .write = write};
}

}  // namespace core
