# Which metric agrees with people, and where the patterns lie: the program's numbers in R, through
# reticulate (r-cran-reticulate).
#
#     Rscript assets/vignettes/map_and_table.R SET [MAP.png [RATINGS]]
#
# with python3-tactspace installed, or PYTHONPATH=build/release/python after "app/run python". SET is a
# set of patterns, such as assets/sets/morse_rothkopf_1957.tactspace.json, which brings along what 598
# people said who heard it; RATINGS a file or a folder of other ratings. Prints the layout of Table 2 in
# Lim & Park 2023, as "tactspace compare --paper-mode" does. Whole numbers need R's L, and places count
# from 0, as in Python.

given <- commandArgs(trailingOnly = TRUE)
if (length(given) < 1 || length(given) > 3) stop("expected SET [MAP.png [RATINGS]]")
if (Sys.getenv("RETICULATE_PYTHON") == "") Sys.setenv(RETICULATE_PYTHON = "/usr/bin/python3")
tactspace <- reticulate::import("tactspace")

set <- tactspace$read_set(given[1])
cat(set$name, "\n")
distances <- tactspace$predict(set$waves, model = set$model)
most <- tactspace$subset(distances, min(8L, nrow(distances)), keep = as.list(set$locked),
                         drop = as.list(set$dropped))
cat("most distinct:", paste(set$names[most$members + 1L], collapse = ", "), "\n")

if (length(given) > 1) {
    map <- tactspace$space(distances, dimensions = 2L)
    points <- map[[1]]
    grDevices::png(given[2], width = 900, height = 900, res = 150)
    plot(points, asp = 1, pch = 19, axes = FALSE, xlab = "", ylab = "",
         main = sprintf("predicted perceptual space, stress-1 %.3f", map[[2]]))
    text(points, labels = set$names, pos = 4, cex = 0.6)
    invisible(grDevices::dev.off())
}

digits <- function(number) if (is.nan(number)) "-" else sprintf("%.2f", number)
ratings <- if (length(given) > 2) tactspace$read_ratings(given[3], set$names) else set$ratings
if (!is.null(ratings)) {
    if (length(ratings$synthetic) > 0)
        cat("SYNTHETIC: some or all of these ratings were given by nobody\n")
    cat(sprintf("%-15s%6s%6s\n", "metric", "rho", "K"))
    for (metric in unlist(tactspace$metrics)) {
        by <- tactspace$predict(set$waves, metric, model = set$model)
        agreement <- tactspace$compare(by, ratings, metric)
        cat(sprintf("%-15s%6s%6s\n", metric, digits(agreement$rho), digits(agreement$K_paper)))
    }
}
