// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_POSSIBLE_FILES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_POSSIBLE_FILES_H

#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// The readers of CGAL make as many points, faces and corners as a file tells of, be there a byte for each or not: a
// damaged number takes all memory that there is, and the system may end other programs for it.

// Of the vertices of a face: no face has as many as that.
template <class T>
struct Polygon_allocator : std::allocator<T>
{
  static constexpr std::size_t most = std::size_t(1) << 24;

  template <class U>
  struct rebind
  {
    using other = Polygon_allocator<U>;
  };
  Polygon_allocator() = default;
  template <class U>
  Polygon_allocator(const Polygon_allocator<U>&)
  {}
  T* allocate(std::size_t n) { return n > most ? throw std::bad_alloc() : std::allocator<T>::allocate(n); }
};

using Polygon = std::vector<std::size_t, Polygon_allocator<std::size_t>>;

inline std::size_t bytes_left(std::istream& in)
{
  const auto start = in.tellg();
  in.seekg(0, std::ios::end);
  const auto end = in.tellg();
  in.seekg(start);
  return static_cast<std::size_t>(end - start);
}

inline bool is_off_possible(std::istream& off)
{
  const std::size_t bytes = bytes_left(off);
  CGAL::File_header_OFF header;
  return off >> header && header.size_of_vertices() <= bytes && header.size_of_facets() <= bytes;
}

// What the header of a PLY file tells that follows it. Lists whose numbers of items are of one or two bytes are short.
class Ply_layout
{
public:
  // False where the header itself cannot be given to the reader of CGAL, which adds a property before all elements to
  // the last element there is.
  bool read(std::istream& ply)
  {
    m_bytes = bytes_left(ply);
    for(std::string line; std::getline(ply, line);)
    {
      std::istringstream words(line);
      std::string keyword, type, item, name;
      std::size_t number;
      words >> keyword;
      if(keyword == "end_header")
        break;
      if(keyword == "format" && words >> type)
        m_is_text = type == "ascii", m_is_big_endian = type == "binary_big_endian";
      else if(keyword == "element" && words >> name >> number)
      {
        if(number > m_bytes)
          return false;
        m_elements.push_back({number, {}});
      }
      else if(keyword == "property")
      {
        if(m_elements.empty())
          return false;
        words >> type;
        if(type == "list" && words >> type >> item)
          add_property(kind(type), kind(item));
        else
          add_property({}, kind(type));
      }
    }
    return true;
  }

  // Are there no more items in any list than bytes in the file?
  bool are_lists_possible(std::istream& ply) const
  {
    if(!m_has_long_lists || m_bytes == static_cast<std::size_t>(-1))
      return true;
    for(const Element& element : m_elements)
      for(std::size_t i = 0; i < element.number; ++i)
        for(const Property& property : element.properties)
        {
          const double items = property.size.bytes == 0 ? 1. : next(ply, property.size);
          if(!ply || !(items >= 0. && items <= static_cast<double>(m_bytes)))
            return false;
          for(std::size_t k = 0; k < static_cast<std::size_t>(items) && ply; ++k)
            next(ply, property.item);
        }
    return !!ply;
  }

private:
  struct Kind
  {
    std::size_t bytes = 0; // 0: none
    bool is_signed = false, is_float = false;
  };
  struct Property
  {
    Kind size, item; // a list has a size
  };
  struct Element
  {
    std::size_t number;
    std::vector<Property> properties;
  };

  static Kind kind(const std::string& name)
  {
    static const std::vector<std::pair<const char*, Kind>> kinds{
        {"char", {1, true, false}},    {"int8", {1, true, false}},    {"uchar", {1, false, false}},
        {"uint8", {1, false, false}},  {"short", {2, true, false}},   {"int16", {2, true, false}},
        {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, true, false}},
        {"int32", {4, true, false}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
        {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
        {"float64", {8, true, true}}};
    for(const auto& known : kinds)
      if(name == known.first)
        return known.second;
    return {};
  }

  void add_property(const Kind& size, const Kind& item)
  {
    if(item.bytes == 0) // the reader leaves it out as well
      return;
    m_elements.back().properties.push_back({size, item});
    // a negative number of items is a large one for the reader
    m_has_long_lists = m_has_long_lists || size.bytes > 2 || (size.bytes > 0 && size.is_signed);
  }

  double next(std::istream& ply, const Kind& kind) const
  {
    if(m_is_text)
      return kind.is_float ? next_word<double>(ply) : static_cast<double>(next_word<long long>(ply));
    unsigned char bytes[8] = {};
    ply.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(kind.bytes));
    if(m_is_big_endian)
      std::reverse(bytes, bytes + kind.bytes);
    if(kind.is_float)
      return kind.bytes == 4 ? as<float>(bytes) : as<double>(bytes);
    if(kind.bytes == 1)
      return kind.is_signed ? as<std::int8_t>(bytes) : as<std::uint8_t>(bytes);
    if(kind.bytes == 2)
      return kind.is_signed ? as<std::int16_t>(bytes) : as<std::uint16_t>(bytes);
    return kind.is_signed ? as<std::int32_t>(bytes) : as<std::uint32_t>(bytes);
  }

  template <class T>
  static T next_word(std::istream& ply)
  {
    T result = 0;
    ply >> CGAL::IO::iformat(result);
    return result;
  }

  template <class T>
  static T as(const unsigned char* bytes)
  {
    T result;
    std::memcpy(&result, bytes, sizeof(T));
    return result;
  }

  std::size_t m_bytes = 0;
  bool m_is_text = true, m_is_big_endian = false, m_has_long_lists = false;
  std::vector<Element> m_elements;
};

inline bool is_ply_possible(std::istream& ply)
{
  Ply_layout layout;
  return layout.read(ply) && layout.are_lists_possible(ply);
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_POSSIBLE_FILES_H
