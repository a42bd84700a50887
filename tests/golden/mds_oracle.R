# Writes mds.json, beside this script, from two independent programs for non-metric scaling.
#
# Source   isoMDS of MASS (Venables & Ripley), monoMDS of vegan (Kruskal's MDSCAL lineage).
# What     For every matrix and 2 and 3 dimensions: the dissimilarities in condensed order, the
#          classical start (cmdscale), stress-1 of isoMDS from that start and the best stress-1 of
#          monoMDS from 20 random starts. Both programs' stopping rules are tightened, so that they
#          are the strongest opponents they can be.
# Matrices am8_pm: the model's eight AM patterns, ranks with ties; random: no structure at all;
#          noisy: points in a cube of three dimensions, distances times 0.75 to 1.25;
#          tied: random, rounded to six levels. No zeros: isoMDS refuses them.
#          isoMDS keeps the first order of tied pairs, which is a harder fit than primary ties.
# Run      Rscript tests/golden/mds_oracle.R

suppressMessages({library(MASS); library(vegan)})

state <- 0
seed <- function(value) state <<- value
# In [0, 1): a linear congruential generator that any language makes to the bit.
uniform <- function(count) vapply(seq_len(count), function(k) {
    state <<- (1664525 * state + 1013904223) %% 4294967296
    state / 4294967296
}, numeric(1))

random <- function(n, value) { seed(value); 0.05 + 0.95 * uniform(n * (n - 1) / 2) }
noisy <- function(n, value) {
    seed(value)
    points <- matrix(uniform(3 * n), n, 3)
    as.vector(dist(points)) * (0.75 + 0.5 * uniform(n * (n - 1) / 2))
}
tied <- function(n, value) { seed(value); 1 + floor(6 * uniform(n * (n - 1) / 2)) }

matrices <- list(
    am8_pm = c(19, 22, 22, 18, 10, 2, 3.5, 8.5, 19, 20.5, 19, 17, 19.5, 14, 15.5, 18, 21.5, 23.5, 7,
               10.5, 19.5, 24, 5.5, 11.5, 20.5, 5, 7.5, 2.5),
    random8 = random(8, 8), random12 = random(12, 12), random20 = random(20, 20),
    noisy10 = noisy(10, 10), noisy14 = noisy(14, 14), noisy30 = noisy(30, 30),
    tied12 = tied(12, 112))

list_of <- function(values) paste0("[", paste(sprintf("%.17g", values), collapse = ", "), "]")
rows_of <- function(m) paste0("[", paste(apply(m, 1, list_of), collapse = ", "), "]")

entry <- function(name, k) {
    condensed <- matrices[[name]]
    n <- (1 + sqrt(1 + 8 * length(condensed))) / 2
    d <- structure(condensed, class = "dist", Size = n, Diag = FALSE, Upper = FALSE)
    start <- suppressWarnings(cmdscale(d, k))
    iso <- isoMDS(d, y = start, k = k, maxit = 500, tol = 1e-7, trace = FALSE)$stress / 100
    set.seed(1)
    mono <- min(replicate(20, monoMDS(d, k = k, maxit = 2000, smin = 1e-8, sfgrmin = 1e-10,
                                      sratmax = 0.9999999)$stress))
    sprintf(paste0('    {"name": "%s", "size": %d, "dimensions": %d,\n',
                   '     "condensed": %s,\n     "start": %s,\n',
                   '     "isoMDS": %.17g, "monoMDS_best_of_20": %.17g}'),
            name, n, k, list_of(condensed), rows_of(start), iso, mono)
}

made_by <- sprintf("Rscript tests/golden/mds_oracle.R (%s, MASS %s, vegan %s)",
                   R.version.string, packageVersion("MASS"), packageVersion("vegan"))
cases <- unlist(lapply(names(matrices), function(name) c(entry(name, 2), entry(name, 3))))
script <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
writeLines(c("{", sprintf('  "made_by": "%s",', made_by), '  "cases": [',
             paste(cases, collapse = ",\n"), "  ]", "}"),
           file.path(dirname(script), "mds.json"))
