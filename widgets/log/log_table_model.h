#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <QString>

#include <deque>
#include <vector>

namespace halbench::widgets {

enum class LogLevel { Debug, Information, Warning, Error };

struct LogEntry {
    double time_s = 0.0; ///< on the clock of whoever says it
    LogLevel level = LogLevel::Information;
    QString source; ///< e.g. "link", "board", "identify"
    QString text;
    QDateTime wall = {}; ///< on the wall's clock; invalid where nobody looked at it
};

/// The last messages. What is said again right after itself is counted, not repeated, so that a flood neither
/// hides what came before nor costs memory.
class LogTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { ClockColumn, TimeColumn, LevelColumn, SourceColumn, TextColumn };
    static constexpr int Columns = TextColumn + 1;
    enum DataRole { LevelRole = Qt::UserRole };
    static constexpr std::size_t MostEntries = 10000;

    using QAbstractTableModel::QAbstractTableModel;

    void append(const std::vector<LogEntry>& entries);
    void clear();
    QString lineText(int row) const; ///< tab separated, for the clipboard

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        LogEntry entry;
        int times = 1;
    };

    bool countRepetition(const LogEntry& entry);
    QString cellText(const Row& row, int column) const;

    std::deque<Row> m_rows;
};

QString levelText(LogLevel level);

} // namespace halbench::widgets
