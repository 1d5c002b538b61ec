// SPDX-License-Identifier: BSD-3-Clause
// HDF5 error text and element types.
#include "storage/hdf5_handle.hpp"

namespace rouleau::hdf5 {
namespace {

herr_t keep_description(unsigned, const H5E_error2_t* error, void* text) {
  auto* description = static_cast<std::string*>(text);
  if (error->desc != nullptr) *description = error->desc;
  return 0;
}

}  // namespace

std::string last_failure() {
  std::string description;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &description);
  H5Eclear2(H5E_DEFAULT);
  return description.empty() ? "no reason given by the HDF5 library" : description;
}

void silence() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

hid_t element_type(ElementType type) {
  switch (type) {
    case ElementType::f32:
      return H5T_IEEE_F32LE;
    case ElementType::f64:
      return H5T_IEEE_F64LE;
    case ElementType::u8:
      return H5T_STD_U8LE;
    case ElementType::i32:
      return H5T_STD_I32LE;
    case ElementType::i64:
      return H5T_STD_I64LE;
  }
  return -1;
}

}  // namespace rouleau::hdf5
