/* session.c - see session.h. Open MPI's mpirun sets OMPI_COMM_WORLD_RANK and _SIZE, and names the job by
 * PMIx. Slurm's srun sets SLURM_STEP_* for a step of a job; a batch script outside srun has no step and is a
 * single process. */
#include "lab/jobs/session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static unsigned number(const char *name)
{
    const char *text = getenv(name);
    return text ? (unsigned)strtoul(text, NULL, 10) : 0;
}

static const char *text(const char *name)
{
    const char *value = getenv(name);
    return value ? value : "";
}

struct session session_find(void)
{
    struct session t = {.count = 1};
    if (number("OMPI_COMM_WORLD_SIZE") > 1) {
        t.rank = number("OMPI_COMM_WORLD_RANK");
        t.count = number("OMPI_COMM_WORLD_SIZE");
        snprintf(t.name, sizeof t.name, "mpirun %.60s %.60s", text("PMIX_NAMESPACE"),
                 text("OMPI_MCA_orte_hnp_uri"));
        t.name[strcspn(t.name, "\n")] = '\0';
    } else if (number("SLURM_STEP_NUM_TASKS") > 1 && *text("SLURM_STEP_ID") && *text("SLURM_PROCID")) {
        t.rank = number("SLURM_PROCID");
        t.count = number("SLURM_STEP_NUM_TASKS");
        snprintf(t.name, sizeof t.name, "srun %.60s.%.60s", text("SLURM_JOB_ID"), text("SLURM_STEP_ID"));
    }
    return t;
}
