#!/usr/bin/awk -f
# Reads the CSV of bench_constructions and prints a Markdown table: for each construction, degree and size of the numbers the
# median times in microseconds of both sides, and the median, least and greatest ratio over the repetitions.
BEGIN { FS = "," }

# "casteljau/engine/10/64",iterations,real_time,cpu_time,time_unit,... : one line a repetition, in their order
$1 ~ /\/(engine|textbook)\/[0-9]+\/[0-9]+"?$/ && $5 == "ns" {
  gsub(/"/, "", $1)
  split($1, part, "/")
  row = part[1] "/" part[3] "/" part[4]
  if (!(row in known)) { known[row] = 1; order[++rows] = row }
  count[row, part[2]]++
  time[row, part[2], count[row, part[2]]] = $4
}

function sort(values, n,    i, j, held) {
  for (i = 2; i <= n; i++) {
    held = values[i]
    for (j = i - 1; j >= 1 && values[j] > held; j--) values[j + 1] = values[j]
    values[j + 1] = held
  }
}
function middle(values, n) { return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2 }
function median_time(row, side,    i, n, values) {
  n = count[row, side]
  for (i = 1; i <= n; i++) values[i] = time[row, side, i]
  sort(values, n)
  return middle(values, n) / 1000
}

END {
  if (rows == 0) { print "no measurements in the input" > "/dev/stderr"; exit 1 }
  print "| construction | degree | bits | engine, us | textbook, us | ratio | range |"
  print "| --- | ---: | ---: | ---: | ---: | ---: | --- |"
  fflush()
  in_order = "sort -t '|' -k2,2 -k3,3n -k4,4n"
  for (r = 1; r <= rows; r++) {
    row = order[r]
    n = count[row, "engine"]
    for (i = 1; i <= n; i++) ratio[i] = time[row, "textbook", i] / time[row, "engine", i]
    sort(ratio, n)
    split(row, part, "/")
    printf "| %s | %s | %s | %.4g | %.4g | %.2g | %.2g to %.2g |\n", part[1], part[2], part[3],
      median_time(row, "engine"), median_time(row, "textbook"), middle(ratio, n), ratio[1], ratio[n] | in_order
  }
  close(in_order)
}
