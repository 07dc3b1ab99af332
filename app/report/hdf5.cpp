#include "app/report/hdf5.h"

#include <algorithm>
#include <utility>

namespace dougong::app::h5 {
namespace {

constexpr hsize_t compress_from = 4096;  // values; smaller datasets stay contiguous
constexpr hsize_t chunk_values = 32768;  // 256 KiB of doubles
constexpr unsigned deflate_level = 1;

herr_t keep_first(unsigned, const H5E_error2_t* entry, void* out) {
  auto& text = *static_cast<std::string*>(out);
  if (text.empty() && entry->desc != nullptr) text = entry->desc;
  return 0;
}

/// The innermost message on HDF5's error stack.
std::string reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &text);
  return text.empty() ? "unknown HDF5 error" : text;
}

void check(herr_t status, const std::string& what) {
  if (status < 0) throw Error(what + ": " + reason());
}

Handle space_of(const Shape& shape) {
  const hid_t id = shape.empty() ? H5Screate(H5S_SCALAR)
                                 : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  return {id, H5Sclose, "dataspace"};
}

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "text type");
  check(H5Tset_size(type, H5T_VARIABLE), "text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "text type");
  return type;
}

hsize_t count(const Shape& shape) {
  hsize_t n = 1;
  for (const hsize_t extent : shape) n *= extent;
  return n;
}

/// Whole rows, as many as fit a chunk.
Shape chunk_of(const Shape& shape) {
  Shape chunk = shape;
  const hsize_t row = std::max<hsize_t>(1, count(shape) / shape[0]);
  chunk[0] = std::clamp<hsize_t>(chunk_values / row, 1, shape[0]);
  return chunk;
}

/// No time stamps (the same run gives the same bytes), compression for what is long.
Handle creation_plan(const Shape& shape, bool numbers) {
  Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset plan");
  check(H5Pset_obj_track_times(plan, false), "dataset plan");
  if (!numbers || shape.empty() || count(shape) < compress_from) return plan;
  const Shape chunk = chunk_of(shape);
  check(H5Pset_chunk(plan, static_cast<int>(chunk.size()), chunk.data()), "dataset chunks");
  check(H5Pset_shuffle(plan), "dataset filter");
  check(H5Pset_deflate(plan, deflate_level), "dataset filter");
  return plan;
}

Handle make_dataset(hid_t parent, const std::string& name, hid_t type, const Shape& shape, bool numbers) {
  const Handle space = space_of(shape);
  const Handle plan = creation_plan(shape, numbers);
  return {H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, plan, H5P_DEFAULT), H5Dclose,
          "dataset " + name};
}

void fill(hid_t dataset, hid_t memory_type, const Shape& shape, const void* values, const std::string& name) {
  if (count(shape) == 0) return;
  check(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "dataset " + name);
}

Handle open_dataset(hid_t parent, const std::string& name) {
  return {H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, "dataset " + name};
}

std::size_t points(hid_t dataset, const std::string& name) {
  const Handle space(H5Dget_space(dataset), H5Sclose, "dataset " + name);
  const hssize_t n = H5Sget_simple_extent_npoints(space);
  check(n < 0 ? -1 : 0, "dataset " + name);
  return static_cast<std::size_t>(n);
}

template <class T>
std::vector<T> read_all(hid_t parent, const std::string& name, hid_t memory_type) {
  const Handle dataset = open_dataset(parent, name);
  std::vector<T> values(points(dataset, name));
  if (values.empty()) return values;
  check(H5Dread(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "dataset " + name);
  return values;
}

const char* as_c_text(const std::string& text, const std::string& name) {
  if (text.find('\0') != std::string::npos) throw Error("dataset " + name + ": text with a zero byte");
  return text.c_str();
}

}  // namespace

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw Error(what + ": " + reason());
}
Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}
Quiet::~Quiet() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

Handle new_file_in_memory() {
  constexpr std::size_t growth = 16u << 20;  // bytes
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access");
  check(H5Pset_fapl_core(access, growth, false), "file access");
  return {H5Fcreate("dougong-results", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "file in memory"};
}

std::string image(hid_t file) {
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "file image");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  check(size < 0 ? -1 : 0, "file image");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(file, bytes.data(), bytes.size()) < 0 ? -1 : 0, "file image");
  return bytes;
}

Handle open_file(const std::filesystem::path& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access");
  check(H5Pset_file_locking(access, false, true), "file access");
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, "file"};
}

Handle make_group(hid_t parent, const std::string& name) {
  const Handle plan(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "group plan");
  check(H5Pset_obj_track_times(plan, false), "group plan");
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, plan, H5P_DEFAULT), H5Gclose, "group " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "group " + name};
}

bool has(hid_t parent, const std::string& name) {
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

void write_text_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Handle space = space_of({}), type = text_type();
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "attribute " + name);
  const char* pointer = as_c_text(text, name);
  check(H5Awrite(attribute, type, &pointer), "attribute " + name);
}

void write_integer_attribute(hid_t object, const std::string& name, std::int64_t value) {
  const Handle space = space_of({});
  const Handle attribute(H5Acreate2(object, name.c_str(), H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "attribute " + name);
  check(H5Awrite(attribute, H5T_NATIVE_INT64, &value), "attribute " + name);
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "attribute " + name);
  const Handle type = text_type();
  char* pointer = nullptr;
  check(H5Aread(attribute, type, &pointer), "attribute " + name);
  const std::string text = pointer == nullptr ? "" : pointer;
  H5free_memory(pointer);
  return text;
}

std::int64_t read_integer_attribute(hid_t object, const std::string& name) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "attribute " + name);
  std::int64_t value = 0;
  check(H5Aread(attribute, H5T_NATIVE_INT64, &value), "attribute " + name);
  return value;
}

void write_numbers(hid_t parent, const std::string& name, const std::string& unit, const Shape& shape,
                   const double* values) {
  const Handle dataset = make_dataset(parent, name, H5T_IEEE_F64LE, shape, true);
  fill(dataset, H5T_NATIVE_DOUBLE, shape, values, name);
  write_text_attribute(dataset, "unit", unit);
}

void write_integers(hid_t parent, const std::string& name, const Shape& shape, const std::int64_t* values) {
  const Handle dataset = make_dataset(parent, name, H5T_STD_I64LE, shape, true);
  fill(dataset, H5T_NATIVE_INT64, shape, values, name);
}

void write_texts(hid_t parent, const std::string& name, const Shape& shape,
                 const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(as_c_text(text, name));
  const Handle type = text_type();
  const Handle dataset = make_dataset(parent, name, type, shape, false);
  fill(dataset, type, shape, pointers.data(), name);
}

std::vector<double> read_numbers(hid_t parent, const std::string& name) {
  return read_all<double>(parent, name, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> read_integers(hid_t parent, const std::string& name) {
  return read_all<std::int64_t>(parent, name, H5T_NATIVE_INT64);
}

std::vector<std::string> read_texts(hid_t parent, const std::string& name) {
  const Handle type = text_type();
  std::vector<char*> pointers = read_all<char*>(parent, name, type);
  std::vector<std::string> texts;
  for (char* pointer : pointers) {
    texts.emplace_back(pointer == nullptr ? "" : pointer);
    H5free_memory(pointer);
  }
  return texts;
}

}  // namespace dougong::app::h5
