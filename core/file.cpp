#include "core/file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <memory>
#include <openssl/evp.h>
#include <sstream>
#include <unistd.h>
#include <zlib.h>

#include "core/error.h"

namespace core {

namespace {

constexpr std::size_t kChunk = 1 << 16;

bool isGzip(std::string_view content) { return content.size() >= 2 && content[0] == '\x1f' && content[1] == '\x8b'; }

std::string inflated(const std::filesystem::path& file, std::string_view content) {
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  const std::unique_ptr<z_stream, int (*)(z_streamp)> guard(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  std::string text;
  std::array<char, kChunk> buffer{};
  while (true) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = kChunk;
    const int code = inflate(&stream, Z_NO_FLUSH);
    text.append(buffer.data(), kChunk - stream.avail_out);
    if (code == Z_STREAM_END && stream.avail_in > 0 && inflateReset(&stream) == Z_OK) continue;  // next member
    if (code == Z_STREAM_END) return text;
    if (code != Z_OK || (stream.avail_in == 0 && stream.avail_out > 0)) {
      throw InputError({.file = file}, "the gzip data are damaged or cut off.", "Copy or export the file again.");
    }
  }
}

std::string deflated(std::string_view content) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  const std::unique_ptr<z_stream, int (*)(z_streamp)> guard(&stream, deflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  std::string bytes(deflateBound(&stream, content.size()) + 32, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  return bytes;
}

[[noreturn]] void throwCannotWrite(const std::filesystem::path& file, int code) {
  throw InputError({.file = file}, std::string("cannot be written: ") + std::strerror(code) + ".",
                   code == ENOSPC ? "Free some space on the disk; nothing was changed."
                                  : "Check that the folder exists and that you may write there; nothing was changed.");
}

void writeAll(int descriptor, const std::filesystem::path& target, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throwCannotWrite(target, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Into a device or pipe (/dev/null, /dev/stdout): renaming over it would replace the device itself by a file.
void writeThrough(const std::filesystem::path& device, std::string_view bytes) {
  const int descriptor = ::open(device.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throwCannotWrite(device, errno);
  const std::unique_ptr<const int, void (*)(const int*)> guard(&descriptor, [](const int* open) { ::close(*open); });
  writeAll(descriptor, device, bytes);
}

/// A temporary file that is gone unless it was renamed into place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target), path_(target.string() + ".part" + std::to_string(::getpid())) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throwCannotWrite(target_, errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) { writeAll(descriptor_, target_, bytes); }

  void moveIntoPlace() {
    if (::fsync(descriptor_) != 0) throwCannotWrite(target_, errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(path_.c_str(), target_.c_str()) != 0) throwCannotWrite(target_, errno);
    renamed_ = true;
  }

 private:
  std::filesystem::path target_;
  std::string path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

std::string readFile(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) {
    throw InputError({.file = file}, "is a folder; a file was expected.", "Name a file in it.");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError({.file = file}, std::string("cannot be read: ") + std::strerror(errno) + ".",
                     "Check the name and that you may read it.");
  }
  std::ostringstream content;
  content << stream.rdbuf();
  std::string text = std::move(content).str();
  return isGzip(text) ? inflated(file, text) : text;
}

void writeFile(const std::filesystem::path& file, std::string_view content) {
  const std::string packed = file.extension() == ".gz" ? deflated(content) : std::string();
  const std::string_view bytes = packed.empty() ? content : std::string_view(packed);
  std::error_code absent;
  const auto status = std::filesystem::status(file, absent);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_directory(status)) {
    writeThrough(file, bytes);
    return;
  }
  const auto target = std::filesystem::is_symlink(file, absent) ? std::filesystem::weakly_canonical(file) : file;
  TemporaryFile temporary(target);
  temporary.write(bytes);
  temporary.moveIntoPlace();
}

std::string sha256(std::string_view content) {
  std::array<unsigned char, 32> digest{};
  unsigned int length = 0;
  EVP_Digest(content.data(), content.size(), digest.data(), &length, EVP_sha256(), nullptr);
  std::string text;
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string sha256OfFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return sha256(readFile(file));  // throws with the reason
  std::ostringstream content;
  content << stream.rdbuf();
  return sha256(std::move(content).str());
}

std::filesystem::path resourceFolder() {
  if (const char* folder = std::getenv("FIDELIS_RESOURCES")) return folder;
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const auto installed = program.parent_path().parent_path() / "share" / "fidelis";
  if (!ignored && std::filesystem::is_directory(installed)) return installed;
  return FIDELIS_SOURCE_RESOURCES;
}

}  // namespace core
