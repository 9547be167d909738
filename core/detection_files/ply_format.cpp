// PLY, the polygon file format, of which only the points (element vertex) are read: a text header that declares
// elements with typed properties, then their values as text or as records in either byte order.
// Source: G. Turk, "The PLY Polygon File Format", 1994.

#include <fmt/format.h>
#include <map>

#include "core/detection_files/detection_format.h"
#include "core/detection_files/header_lines.h"
#include "core/detection_files/point_table.h"
#include "core/text.h"

namespace core {

namespace {

struct Property {
  std::string name;
  NumberType type = NumberType::kF32;
  std::optional<NumberType> length;  // of the number of entries, if it is a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::vector<Element> elements;
  std::string format;     // ascii, binary_little_endian, binary_big_endian
  std::size_t begin = 0;  // byte at which the values begin
  int line = 0;           // last line of the header
};

InputError damaged(const Place& place, const std::string& problem) {
  return {place, problem, "Copy or export the file again."};
}

NumberType typeOf(const Place& place, const std::string& name) {
  static const std::map<std::string, NumberType> known{
      {"char", NumberType::kI8},    {"int8", NumberType::kI8},     {"uchar", NumberType::kU8},
      {"uint8", NumberType::kU8},   {"short", NumberType::kI16},   {"int16", NumberType::kI16},
      {"ushort", NumberType::kU16}, {"uint16", NumberType::kU16},  {"int", NumberType::kI32},
      {"int32", NumberType::kI32},  {"uint", NumberType::kU32},    {"uint32", NumberType::kU32},
      {"float", NumberType::kF32},  {"float32", NumberType::kF32}, {"double", NumberType::kF64},
      {"float64", NumberType::kF64}};
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  throw damaged(place, "'" + name + "' is no type of a property.");
}

Property propertyOf(const Place& place, const std::vector<std::string>& words) {
  if (words.size() == 5 && words[1] == "list") {
    return {words[4], typeOf(place, words[3]), typeOf(place, words[2])};
  }
  if (words.size() != 3) throw damaged(place, "is no declaration of a property.");
  return {words[2], typeOf(place, words[1]), std::nullopt};
}

void readFormat(const Place& place, const std::vector<std::string>& words, Header& header) {
  header.format = words.size() > 1 ? words[1] : "";
  if (header.format == "ascii" || header.format == "binary_little_endian" || header.format == "binary_big_endian") {
    return;
  }
  throw InputError(place, "format '" + header.format + "' is unknown.",
                   "Known are ascii, binary_little_endian and binary_big_endian.");
}

Header readHeader(const std::filesystem::path& file, std::string_view content) {
  HeaderLines lines(file, content);
  Header header;
  const auto first = lines.next();
  if (!first || *first != std::vector<std::string>{"ply"}) {
    throw damaged({.file = file, .line = 1}, "is no PLY file: the line 'ply' is missing.");
  }
  while (true) {
    const auto words = lines.next();
    if (!words) throw damaged({.file = file}, "ends before the line end_header.");
    const std::string key = words->empty() ? "" : words->front();
    if (key == "end_header") break;
    if (key == "format") {
      readFormat(lines.place(), *words, header);
    } else if (key == "element" && words->size() == 3) {
      header.elements.push_back({(*words)[1], countOf(lines.place(), "element " + (*words)[1], (*words)[2]), {}});
    } else if (key == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(propertyOf(lines.place(), *words));
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      throw damaged(lines.place(), "'" + key + "' is not understood here.");
    }
  }
  if (header.format.empty()) throw damaged({.file = file}, "the header has no line format.");
  header.begin = lines.offset();
  header.line = lines.line();
  return header;
}

/// The values of an element's entry one after the other, as text or as records.
class Values {
 public:
  Values(const DetectionSource& source, const Header& header)
      : source_(source),
        order_(header.format == "binary_big_endian" ? std::endian::big : std::endian::little),
        text_(header.format == "ascii"),
        offset_(header.begin),
        lines_(source.file, source.content) {
    while (text_ && lines_.line() < header.line) (void)lines_.next();
  }

  /// Begins the next entry of `element`.
  void nextEntry(const Element& element, std::size_t number) {
    element_ = &element;
    number_ = number;
    begin_ = offset_;
    if (!text_) return;
    word_ = 0;
    do {
      const auto words = lines_.next();
      if (!words) throw cutOff();
      words_ = *words;
    } while (words_.empty());
  }

  double next(NumberType type) {
    if (text_) {
      if (word_ >= words_.size()) throw damaged(place(), "has too few numbers.");
      return numberOf(place(), "element " + element_->name, words_[word_++]);
    }
    if (source_.content.size() - offset_ < sizeOf(type)) throw cutOff();
    const double value = loadNumber(source_.content.data() + offset_, type, order_);
    offset_ += sizeOf(type);
    return value;
  }

  /// Where the entry that was begun last lies: a line, or the byte at which it begins.
  [[nodiscard]] std::size_t position() const { return text_ ? static_cast<std::size_t>(lines_.line()) : begin_; }
  [[nodiscard]] Place placeAt(std::size_t position, std::size_t number) const {
    if (text_) return {.file = source_.file, .line = static_cast<int>(position), .item = ""};
    return {.file = source_.file, .line = 0, .item = fmt::format("point {} (byte {})", number + 1, position)};
  }

 private:
  [[nodiscard]] Place place() const { return placeAt(position(), number_); }
  [[nodiscard]] InputError cutOff() const {
    const Place end{.file = source_.file, .item = fmt::format("byte {}", source_.content.size())};
    return damaged(end, fmt::format("is cut off in entry {} of {} of the element {}.", number_ + 1, element_->count,
                                    element_->name));
  }

  const DetectionSource& source_;
  std::endian order_;
  bool text_;
  std::size_t offset_;
  HeaderLines lines_;
  std::vector<std::string> words_;
  std::size_t word_ = 0;
  const Element* element_ = nullptr;
  std::size_t number_ = 0;
  std::size_t begin_ = 0;
};

/// Reads one entry; `value` gets every number that is not in a list.
template <typename Value>
void eachProperty(const Element& element, Values& values, Value value) {
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const Property& property = element.properties[k];
    if (!property.length) {
      value(k, values.next(property.type));
      continue;
    }
    const double length = values.next(*property.length);
    for (double i = 0; i < length; ++i) (void)values.next(property.type);
  }
}

Detections readPoints(const DetectionSource& source, const Element& points, Values& values) {
  std::vector<std::string> names;
  for (const Property& property : points.properties) names.push_back(property.length ? "" : property.name);
  const auto wanted = wantedFields(source.file, source.columns, names);
  PointTable table;
  std::vector<std::vector<std::size_t>> columns_of(names.size());  // a field may serve more than one column
  for (const WantedField& field : wanted) {
    columns_of[field.index].push_back(table.columns.size());
    table.columns.push_back({field.name, points.properties[field.index].type, {}});
  }
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < points.count; ++i) {
    values.nextEntry(points, i);
    positions.push_back(values.position());
    eachProperty(points, values, [&](std::size_t k, double value) {
      for (const std::size_t column : columns_of[k]) table.columns[column].values.push_back(value);
    });
  }
  return detectionsOf(table, [&](std::size_t point) { return values.placeAt(positions[point], point); });
}

Detections read(const DetectionSource& source) {
  const Header header = readHeader(source.file, source.content);
  Values values(source, header);
  for (const Element& element : header.elements) {
    if (element.name == "vertex") return readPoints(source, element, values);
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      values.nextEntry(element, i);
      eachProperty(element, values, [](std::size_t, double) {});
    }
  }
  throw InputError({.file = source.file}, "has no points: the header declares no element vertex.",
                   "Export the cloud with its points.");
}

bool recognises(std::string_view content) { return content.starts_with("ply\n") || content.starts_with("ply\r\n"); }

std::string headerOf(const PointTable& table, const std::string& encoding) {
  std::string properties;
  for (const PointTable::Column& column : table.columns) {
    const char* type = column.type == NumberType::kF32 ? "float" : column.type == NumberType::kF64 ? "double" : "int";
    properties += fmt::format("property {} {}\n", type, column.name);
  }
  return fmt::format(
      "ply\nformat {} 1.0\ncomment detections in the sensor's frame, x forward, y left, z up\n"
      "element vertex {}\n{}end_header\n",
      encoding, table.size(), properties);
}

std::string write(const Detections& detections, const std::string& encoding) {
  const PointTable table = tableOf(detections);
  std::string out = headerOf(table, encoding);
  const std::endian order = encoding == "binary_big_endian" ? std::endian::big : std::endian::little;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (const PointTable::Column& column : table.columns) {
      if (encoding != "ascii") {
        appendNumber(out, column.values[i], column.type, order);
      } else {
        out += shortestNumber(column.values[i]) + (&column == &table.columns.back() ? "\n" : " ");
      }
    }
  }
  return out;
}

}  // namespace

DetectionFormat plyFormat() {
  return {.name = "ply",
          .title = "PLY point cloud",
          .endings = {".ply"},
          .encodings = {"binary_little_endian", "binary_big_endian", "ascii"},
          .recognises = recognises,
          .read = read,
          .write = write};
}

}  // namespace core
