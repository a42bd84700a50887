# Non-metric scaling by vegan's monoMDS and MASS's isoMDS, for mds_bench.cpp to compare with.
#
# Input    a file of matrices, one a line: objects, starts, 1 to know the least stress they reach or
#          0 to know how long monoMDS takes, and the dissimilarities in condensed order
# Output   a line each: the least stress-1 in 3 dimensions, or seconds of the processor per start
#          with monoMDS's own stopping rules (the fastest of three turns)
#
# For the least stress both stop later than they would, to be the strongest opponents they can be.
suppressMessages({library(MASS); library(vegan)})

seconds <- function(d, starts) {
    turn <- function() {
        begin <- proc.time()[[1]]
        for (start in seq_len(starts)) monoMDS(d, k = 3)
        (proc.time()[[1]] - begin) / starts
    }
    set.seed(1)
    min(replicate(3, turn()))
}

least_stress <- function(d, starts) {
    set.seed(1)
    mono <- min(replicate(starts, monoMDS(d, k = 3, maxit = 1000, smin = 1e-7, sfgrmin = 1e-9,
                                          sratmax = 0.999999)$stress))
    iso <- isoMDS(d, k = 3, maxit = 200, tol = 1e-5, trace = FALSE)$stress / 100
    min(mono, iso)
}

for (line in readLines(commandArgs(TRUE)[1])) {
    numbers <- scan(text = line, quiet = TRUE)
    d <- structure(numbers[-(1:3)], class = "dist", Size = numbers[1], Diag = FALSE, Upper = FALSE)
    measure <- if (numbers[3] == 1) least_stress else seconds
    cat(sprintf("%.17g\n", measure(d, numbers[2])))
}
