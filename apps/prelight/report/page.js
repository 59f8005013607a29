{
  const report = JSON.parse(document.getElementById("data").textContent);
  const runs = report.runs.filter((run) => run.error === null);
  showHeading(report, runs);
  showHighlights(report, runs);
  showSummary(report, runs);
  new Viewer(report, runs);
  showArchitectures(runs);
  showBars(runs);
  showCharts(report);
  showPasses(runs);
}
