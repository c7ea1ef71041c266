#include "widgets/log/log_filter_model.h"

namespace halbench::widgets {

void LogFilterModel::setLeast(LogLevel level) {
    m_least = level;
    invalidateFilter();
}

void LogFilterModel::setWords(const QString& words) {
    m_words = words.trimmed();
    invalidateFilter();
}

bool LogFilterModel::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto text = [&](int column) { return sourceModel()->index(row, column, parent).data().toString(); };
    const int level = sourceModel()->index(row, 0, parent).data(LogTableModel::LevelRole).toInt();
    return level >= static_cast<int>(m_least) &&
           (m_words.isEmpty() || text(LogTableModel::TextColumn).contains(m_words, Qt::CaseInsensitive) ||
            text(LogTableModel::SourceColumn).contains(m_words, Qt::CaseInsensitive));
}

} // namespace halbench::widgets
