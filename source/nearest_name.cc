// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace Riedel
{
  namespace
  {
    std::string
    small_letters(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      });
      return text;
    }
  } // namespace



  unsigned int
  edit_distance(const std::string &first, const std::string &second)
  {
    const std::string a = small_letters(first);
    const std::string b = small_letters(second);

    // distance[i][j] is the distance of the first i letters of a from the
    // first j letters of b
    std::vector<std::vector<unsigned int>> distance(
      a.size() + 1, std::vector<unsigned int>(b.size() + 1));
    for (unsigned int i = 0; i <= a.size(); ++i)
      for (unsigned int j = 0; j <= b.size(); ++j)
        {
          unsigned int &d = distance[i][j];
          if (i == 0 || j == 0)
            {
              d = i + j;
              continue;
            }
          d = std::min({distance[i - 1][j] + 1,
                        distance[i][j - 1] + 1,
                        distance[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
          if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
            d = std::min(d, distance[i - 2][j - 2] + 1);
        }
    return distance[a.size()][b.size()];
  }



  std::vector<std::string>
  nearest_names(const std::string              &name,
                const std::vector<std::string> &candidates)
  {
    std::vector<std::pair<unsigned int, std::string>> near;
    for (const std::string &candidate : candidates)
      {
        unsigned int distance = edit_distance(name, candidate);
        // a word left out or put in front: "Pressure on top" and "pressure"
        const std::string a = small_letters(name), b = small_letters(candidate);
        if (std::min(a.size(), b.size()) >= 4 &&
            (a.find(b) != std::string::npos || b.find(a) != std::string::npos))
          distance = std::min(distance, 3u);
        // about every third letter may be wrong, but not all of a short name
        const std::size_t letters = std::max(name.size(), candidate.size());
        if (distance <= std::max<std::size_t>(1, letters / 3) &&
            distance < letters)
          near.emplace_back(distance, candidate);
      }
    std::stable_sort(near.begin(),
                     near.end(),
                     [](const auto &a, const auto &b) {
                       return a.first < b.first;
                     });

    std::vector<std::string> names;
    for (const auto &[distance, candidate] : near)
      // names much farther away than the nearest only distract
      if (names.size() < 3 && distance <= near.front().first + 1)
        names.push_back(candidate);
    return names;
  }



  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    const std::vector<std::string> names = nearest_names(name, candidates);
    if (names.empty())
      return "";

    std::string text = " Did you mean ";
    for (unsigned int i = 0; i < names.size(); ++i)
      text += (i == 0                ? "" :
               i + 1 == names.size() ? " or " :
                                       ", ") +
              ("\"" + names[i] + "\"");
    return text + "?";
  }



  std::string
  enumerate(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : ", ") + name;
    return text;
  }
} // namespace Riedel
