// A thin layer over the HDF5 C API: handles that close themselves, failures that throw with HDF5's
// own reason, and the few kinds of dataset a results file has.
//
// A file is built in memory (HDF5's core driver) and leaves through write_file(), because a failing
// disk leaves HDF5's own file handles beyond repair; in memory every failure is clean.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace dougong::app::h5 {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An identifier of HDF5 with the function that closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// Throws with `what` and HDF5's reason when the identifier is negative.
  Handle(hid_t id, Close close, const std::string& what);
  ~Handle();
  Handle(Handle&& other) noexcept;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Keeps HDF5 from printing its error stack while in scope.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

using Shape = std::vector<hsize_t>;  // empty for a scalar

Handle new_file_in_memory();
/// The finished file as bytes.
std::string image(hid_t file);
Handle open_file(const std::filesystem::path& path);
Handle make_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);
bool has(hid_t parent, const std::string& name);

void write_text_attribute(hid_t object, const std::string& name, const std::string& text);
void write_integer_attribute(hid_t object, const std::string& name, std::int64_t value);
std::string read_text_attribute(hid_t object, const std::string& name);
std::int64_t read_integer_attribute(hid_t object, const std::string& name);

void write_numbers(hid_t parent, const std::string& name, const std::string& unit, const Shape& shape,
                   const double* values);
void write_integers(hid_t parent, const std::string& name, const Shape& shape, const std::int64_t* values);
void write_texts(hid_t parent, const std::string& name, const Shape& shape,
                 const std::vector<std::string>& texts);
std::vector<double> read_numbers(hid_t parent, const std::string& name);
std::vector<std::int64_t> read_integers(hid_t parent, const std::string& name);
std::vector<std::string> read_texts(hid_t parent, const std::string& name);

}  // namespace dougong::app::h5
