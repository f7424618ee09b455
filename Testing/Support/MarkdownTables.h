// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_MarkdownTables_h
#define Testing_Support_MarkdownTables_h

#include <istream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/** The tables of a Markdown text, by the headings above them; those that follow the first below a
 * heading are "heading 2" and so on. Throws std::runtime_error where a row has more or fewer cells
 * than the head of its table. */
class MarkdownTables
{
public:
  using Row = std::vector<std::string>;
  /** Without the line below the head. */
  using Table = std::vector<Row>;

  explicit MarkdownTables(std::istream& text)
  {
    std::string heading;
    Table* table = nullptr;
    std::map<std::string, int> numbers;
    for (std::string line; std::getline(text, line);)
    {
      if (line.rfind('|', 0) != 0)
      {
        table = nullptr;
        if (line.rfind('#', 0) == 0)
        {
          heading = line.substr(line.find(' ') + 1);
        }
        continue;
      }
      if (!table)
      {
        const int number = ++numbers[heading];
        table = &this->Tables[number == 1 ? heading : heading + " " + std::to_string(number)];
      }
      const Row row = Split(line);
      if (!table->empty() && row.size() != table->front().size())
      {
        throw std::runtime_error("a row has not as many cells as the head: " + line);
      }
      if (row.front() != "---")
      {
        table->push_back(row);
      }
    }
  }

  std::size_t GetSize() const { return this->Tables.size(); }

  /** Throws std::out_of_range when there is none. */
  const Table& Get(const std::string& heading) const { return this->Tables.at(heading); }

  /** The cell of a row, by its first cell, in a column, by its head; the first that fits. Throws
   * std::runtime_error when there is none. */
  std::string GetCell(
    const std::string& heading, const std::string& row, const std::string& column) const
  {
    const Table& table = this->Get(heading);
    for (std::size_t i = 0; i < table.front().size(); ++i)
    {
      for (const Row& cells : table)
      {
        if (table.front()[i] == column && cells.front() == row)
        {
          return cells[i];
        }
      }
    }
    throw std::runtime_error("no cell '" + row + "', '" + column + "' below " + heading);
  }

private:
  static Row Split(const std::string& line)
  {
    Row cells;
    for (std::size_t first = 1; first < line.size();)
    {
      const std::size_t last = line.find('|', first);
      if (last == std::string::npos)
      {
        throw std::runtime_error("a row does not end: " + line);
      }
      const std::string cell = line.substr(first, last - first);
      const std::size_t begin = cell.find_first_not_of(' ');
      cells.push_back(begin == std::string::npos
          ? ""
          : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
      first = last + 1;
    }
    return cells;
  }

  std::map<std::string, Table> Tables;
};

#endif
