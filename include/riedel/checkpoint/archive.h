// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>
#include <string>

namespace Riedel::Checkpoint
{
  /// Everything that @p exchange(archive) hands over with
  /// `archive & value & ...`, as bytes: exact, also for values that are not
  /// numbers.
  template <typename Exchange>
  std::string
  pack(const Exchange &exchange)
  {
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream);
    exchange(archive);
    return stream.str();
  }



  /// The way back, by the same @p exchange. Throws
  /// boost::archive::archive_exception if the bytes come from another one.
  template <typename Exchange>
  void
  unpack(const std::string &bytes, const Exchange &exchange)
  {
    std::istringstream              stream(bytes);
    boost::archive::binary_iarchive archive(stream);
    exchange(archive);
  }
} // namespace Riedel::Checkpoint
