// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_FuzzBytes_h
#define Testing_Fuzz_FuzzBytes_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

/** Reads values from the bytes of a fuzzer, front to back; zeros follow the last byte. */
class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }

  bool IsEmpty() const { return this->Size == 0; }

  template <typename Value>
  Value Read()
  {
    unsigned char bytes[sizeof(Value)] = {};
    const std::size_t size = std::min(this->Size, sizeof(Value));
    std::copy(this->Data, this->Data + size, bytes);
    this->Data += size;
    this->Size -= size;
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }
  unsigned ReadByte() { return this->Read<std::uint8_t>(); }

private:
  const std::uint8_t* Data;
  std::size_t Size;
};

#endif
