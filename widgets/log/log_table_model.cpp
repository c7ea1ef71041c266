#include "widgets/log/log_table_model.h"

#include "widgets/language/display_units.h"
#include "widgets/language/local_time.h"
#include "widgets/theme/icons.h"

#include <QLocale>

namespace halbench::widgets {
namespace {

constexpr int TimeDecimals = 2;

Role roleOfLevel(LogLevel level) {
    switch (level) {
    case LogLevel::Error:
        return Role::Bad;
    case LogLevel::Warning:
        return Role::Warn;
    case LogLevel::Debug:
        return Role::Muted;
    case LogLevel::Information:
        break;
    }
    return Role::None;
}

} // namespace

QString levelText(LogLevel level) {
    switch (level) {
    case LogLevel::Error:
        return LogTableModel::tr("error");
    case LogLevel::Warning:
        return LogTableModel::tr("warning");
    case LogLevel::Debug:
        return LogTableModel::tr("detail");
    case LogLevel::Information:
        break;
    }
    return LogTableModel::tr("note");
}

bool LogTableModel::countRepetition(const LogEntry& entry) {
    if (m_rows.empty() || m_rows.back().entry.text != entry.text ||
        m_rows.back().entry.source != entry.source || m_rows.back().entry.level != entry.level) {
        return false;
    }
    ++m_rows.back().times;
    m_rows.back().entry.time_s = entry.time_s;
    m_rows.back().entry.wall = entry.wall;
    const int last = static_cast<int>(m_rows.size()) - 1;
    Q_EMIT dataChanged(index(last, 0), index(last, TextColumn));
    return true;
}

void LogTableModel::append(const std::vector<LogEntry>& entries) {
    for (const LogEntry& entry : entries) {
        if (countRepetition(entry)) {
            continue;
        }
        if (m_rows.size() == MostEntries) {
            beginRemoveRows({}, 0, 0);
            m_rows.pop_front();
            endRemoveRows();
        }
        const int row = static_cast<int>(m_rows.size());
        beginInsertRows({}, row, row);
        m_rows.push_back({entry, 1});
        endInsertRows();
    }
}

void LogTableModel::clear() {
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

QString LogTableModel::lineText(int row) const {
    const Row& line = m_rows[static_cast<std::size_t>(row)];
    return QStringList{cellText(line, ClockColumn), cellText(line, TimeColumn), levelText(line.entry.level),
                       line.entry.source, cellText(line, TextColumn)}
        .join(QLatin1Char('\t'));
}

int LogTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int LogTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QString LogTableModel::cellText(const Row& row, int column) const {
    switch (column) {
    case ClockColumn:
        return row.entry.wall.toLocalTime().toString(QStringLiteral("HH:mm:ss"));
    case TimeColumn:
        return fixedText(row.entry.time_s, TimeDecimals);
    case LevelColumn:
        return levelText(row.entry.level);
    case SourceColumn:
        return row.entry.source;
    default:
        return row.times == 1 ? row.entry.text : tr("%1 (%2 times)").arg(row.entry.text).arg(row.times);
    }
}

QVariant LogTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const bool isTime = index.column() == ClockColumn || index.column() == TimeColumn;
    switch (role) {
    case Qt::DisplayRole:
        return cellText(row, index.column());
    case Qt::ToolTipRole:
        return index.column() == ClockColumn ? localTimeText(row.entry.wall) : cellText(row, TextColumn);
    case Qt::AccessibleTextRole:
        return cellText(row, index.column());
    case Qt::ForegroundRole:
        return isTime || index.column() == SourceColumn
                   ? currentTheme().muted
                   : roleColour(currentTheme(), roleOfLevel(row.entry.level));
    case Qt::FontRole:
        return isTime ? QVariant(tabularFont(QFont())) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant((isTime ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case LevelRole:
        return static_cast<int>(row.entry.level);
    default:
        return {};
    }
}

QVariant LogTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::ToolTipRole) {
        return QStringList{tr("Local time of this computer"), tr("Device time, as in its recordings")}.value(
            section);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    return QStringList{tr("Clock"), tr("Time [s]"), tr("Level"), tr("Source"), tr("Message")}.value(section);
}

} // namespace halbench::widgets
